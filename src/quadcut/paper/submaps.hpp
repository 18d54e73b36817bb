// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/paper/cut.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// The longest shortest route of a connected graph, every edge counted 1. Found by repeated
/// breadth-first sweeps to the farthest node, so at least one end is extreme: exact on trees, never
/// more than the true value, and in the free space of buildings seldom an edge less. O(edges).
[[nodiscard]] std::size_t longest_route_edges(const Graph& graph);

/// Divides submaps that are too large or too long, or whose halves (cut_in_half()) are related by
/// less than min_relation_per_m. Parts that a cut can no more divide stay. O(log(pieces)) cuts of
/// each submap.
[[nodiscard]] Pieces divide_submaps(const Graph& graph, Pieces pieces, const PaperOptions& options,
                                    std::uint64_t seed, StageClock& clock,
                                    const Executor& executor = {});

/// Fuses submaps by eq. (11), the largest coefficient first: those above the threshold, and small
/// ones with any neighbour.
[[nodiscard]] Pieces fuse_submaps(const Graph& graph, Pieces pieces, const PaperOptions& options);

/// Fuses submaps by eq. (11), the smallest submap first with the neighbour it is related to most,
/// until `count` are left and none is smaller than `min_area_m2`, or nothing is connected any more.
[[nodiscard]] Pieces fuse_submaps_to(const Graph& graph, Pieces pieces, std::uint32_t count,
                                     double min_area_m2 = 0.0);

/// Cuts into `count` submaps. The smallest eigenvectors may be those of slivers along walls, whose
/// pieces are too small for a submap: they are fused, and the cut is repeated with as many
/// eigenvectors more. The nearest number found if `count` cannot be had. A few cuts.
[[nodiscard]] Pieces cut_into(const Graph& graph, std::size_t count, const PaperOptions& options,
                              std::uint64_t seed, StageClock& clock, const Executor& executor = {});

/// The submaps of a region.
struct Submaps {
    /// The nodes that are in one, ascending.
    std::vector<std::uint32_t> nodes;
    /// Their submaps, by place in `nodes`.
    Pieces pieces;
};

/// The paper's method on a region's graph: small connected components are eliminated, the rest is
/// cut, the submaps divided and fused, by rules that look at the submaps alone: a region and a part
/// of it get the same borders but where these are a matter of balance. A number that is given is
/// cut to.
/// Throws NumericalError if the eigensolver fails its own checks.
[[nodiscard]] Submaps find_submaps(const Graph& graph, const PaperOptions& options,
                                   std::uint64_t seed, StageClock& clock, const Executor& executor);

}  // namespace quadcut
