// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/paper/options.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

/// The paper's cut of a region (eqs. 4 to 9): the smallest eigenvectors of its Laplacian, the
/// spectra of its components merged, their rows clustered by k-means, into a given number of
/// clusters (options.num_submaps). When that is 0 the number is that of the eigengap of the graph's
/// basins or, with first_cut=silhouette, the one with the best silhouette. A cluster that falls
/// apart becomes several pieces. Throws NumericalError if the eigensolver fails its own checks.
[[nodiscard]] Pieces cut(const Graph& region, const PaperOptions& options, std::uint64_t seed,
                         StageClock& clock, const Executor& executor = {});

}  // namespace quadcut
