// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

struct CutOptions {
    LaplacianKind laplacian = LaplacianKind::degree;
    /// Pieces are found as many as this; 0: as many as the silhouette likes best.
    std::size_t num_pieces = 0;
    std::size_t max_pieces = 30;
    double min_silhouette = 0.25;
    RowScaling row_scaling = RowScaling::none;
    std::uint64_t seed = 1;
};

/// The paper's cut of a region (eqs. 4 to 9): the smallest eigenvectors of its Laplacian, the
/// spectra of its components merged, their rows clustered by k-means, into a given number of
/// clusters or the one with the best silhouette. A cluster that falls apart becomes several pieces.
/// Throws NumericalError if the eigensolver fails its own checks.
[[nodiscard]] Pieces cut(const Graph& region, const CutOptions& options, StageClock& clock,
                         const Executor& executor = {});

}  // namespace quadcut
