// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/rooms/previous.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

/// The paper's graph G, contracted: a node is a region of the floor, not a leaf.
struct ContractedGraph {
    Graph graph;
    /// By node, ascending.
    std::vector<std::uint32_t> region_of_node;
};

/// The graph of regions that touch: the weight of an edge is border / distance between the
/// centroids, the finite-volume discretisation of the floor, times how open the border is: the
/// square of the clearance at the saddle over the larger of the two regions' peaks, 0..1. Borders
/// and saddles are those that the regions know: no cell is looked at. O(regions + saddles).
[[nodiscard]] ContractedGraph contract(const RegionGraph& regions);

/// Joins the regions of each piece, but not across earlier borders; pieces are those of
/// contract(regions), one a node.
void join_pieces(RegionGraph& regions, const ContractedGraph& contracted, const Pieces& pieces,
                 const EarlierDecisions& earlier = {});

}  // namespace quadcut
