// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <vector>

#include "quadcut/base/ids.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/options.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// The weight of the edge between two leaves of these sides, eq. (2), metres.
[[nodiscard]] double sight_weight(double side_i_m, double side_j_m);

/// The edges of the paper's graph G over a region of the map (Algorithm 2): pairs of leaves at most
/// Th apart, eq. (3), that see each other, criterion 1 as in BlockedCells, with the weight of
/// eq. (2), metres. Edge ends are positions in `nodes`; the coarser leaf comes first (rule 2; of
/// two equal ones the earlier), pairs ascend, each is there once.
///
/// `nodes` are free leaves of the table, ascending; every leaf of the table stands in the way or
/// lets sight pass, in the region or not. The same bytes on any number of threads.
/// Time O(leaves within 2.1 sides of each node + cells crossed), memory O(edges + cells of the
/// region's bounding box / 32). Throws std::logic_error if `nodes` is not as said.
[[nodiscard]] std::vector<WeightedEdge> sight_edges(const LeafTable& table,
                                                    std::span<const LeafId> nodes,
                                                    double resolution_m,
                                                    SelfLoops self_loops = SelfLoops::none,
                                                    const Executor& executor = {});

}  // namespace quadcut
