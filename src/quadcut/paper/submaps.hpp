// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/paper/cut.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// What an ideal submap is, as the paper asks the user to say.
struct SubmapLimits {
    /// A smaller submap is fused with the neighbour it is related to most, m^2.
    double min_area_m2 = 4.0;
    /// A larger submap is divided, and none this large is made by fusing, m^2.
    double max_area_m2 = 400.0;
    /// A submap with a longer shortest route between two of its nodes is divided, edges.
    std::size_t max_route_edges = 60;
    /// Submaps with a larger relative coefficient, eq. (11), are fused, 1/m.
    double min_relation_per_m = 1.0;
};

/// The longest shortest route of a connected graph, every edge counted 1. Found by repeated
/// breadth-first sweeps to the farthest node, so at least one end is extreme: exact on trees, never
/// more than the true value, and in the free space of buildings seldom an edge less. O(edges).
[[nodiscard]] std::size_t longest_route_edges(const Graph& graph);

/// Divides submaps that are too large or too long, by the same cut into two. Parts that a cut can
/// no more divide stay. O(log(pieces)) cuts of each submap.
[[nodiscard]] Pieces divide_submaps(const Graph& graph, Pieces pieces, const SubmapLimits& limits,
                                    const CutOptions& options, StageClock& clock,
                                    const Executor& executor = {});

/// Fuses submaps by eq. (11), the largest coefficient first: those above the threshold, and small
/// ones with any neighbour.
[[nodiscard]] Pieces fuse_submaps(const Graph& graph, Pieces pieces, const SubmapLimits& limits);

/// Fuses submaps by eq. (11), the smallest submap first with the neighbour it is related to most,
/// until `count` are left and none is smaller than `min_area_m2`, or nothing is connected any more.
[[nodiscard]] Pieces fuse_submaps_to(const Graph& graph, Pieces pieces, std::uint32_t count,
                                     double min_area_m2 = 0.0);

/// Cuts into `count` submaps. The smallest eigenvectors may be those of slivers along walls, whose
/// pieces are too small for a submap: they are fused, and the cut is repeated with as many
/// eigenvectors more. The nearest number found if `count` cannot be had. A few cuts.
[[nodiscard]] Pieces cut_into(const Graph& graph, std::size_t count, const SubmapLimits& limits,
                              const CutOptions& options, StageClock& clock,
                              const Executor& executor = {});

}  // namespace quadcut
