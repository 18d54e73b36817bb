// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/visibility.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut::reproduce {

/// The paper's graph G of a map: a node for each free leaf, leaves.nodes[i].
struct MapGraph {
    FreeLeaves leaves;
    Graph graph;
};

/// O(cells + edges).
[[nodiscard]] inline MapGraph graph_of(const GridMap& map, SelfLoops self_loops,
                                       const Executor& executor) {
    MapGraph result{free_leaves(map), {}};
    const FreeLeaves& leaves = result.leaves;
    result.graph =
        build_graph(sight_edges(leaves.table, leaves.nodes, map.resolution_m, self_loops, executor),
                    leaf_areas_m2(leaves.table, leaves.nodes, map.resolution_m));
    return result;
}

}  // namespace quadcut::reproduce
