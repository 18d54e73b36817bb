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

/// A region in two.
struct Halves {
    /// One piece when there is no cut.
    Pieces pieces;
    /// The relative coefficient of the two, eq. (11).
    double relation_per_m = 0.0;
};

/// Cuts a connected region where its normalised cut is least: along the smallest eigenvectors of
/// its Laplacian, rows divided by sqrt(d), each splitting point is tried (Shi, Malik 2000, whom
/// the paper follows). No half is smaller than a submap. A function of the region alone: no start,
/// no number of clusters. O(edges) and one eigenproblem. Throws NumericalError if that fails.
[[nodiscard]] Halves cut_in_half(const Graph& region, const PaperOptions& options,
                                 std::uint64_t seed, StageClock& clock,
                                 const Executor& executor = {});

}  // namespace quadcut
