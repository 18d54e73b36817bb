// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/pieces.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quadcut/map/free_leaves.hpp"
#include "quadcut/rooms/border_edges.hpp"
#include "quadcut/rooms/over_cut.hpp"
#include "quadcut/rooms/snap.hpp"

namespace quadcut {
namespace {

/// A map whose free cells are the open ones.
GridMap map_of(const Raster<std::uint8_t>& open, double resolution_m) {
    GridMap map;
    map.resolution_m = resolution_m;
    map.states = Raster<CellState>(open.origin, open.width, open.height, CellState::occupied);
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        if (open.values[i] != 0) map.states.values[i] = CellState::free;
    }
    return map;
}

/// Border edges; those in narrow places weigh less, so that cuts are drawn to doorways.
Graph narrowness_graph(const FreeLeaves& leaves, const Raster<float>& clearance,
                       double resolution_m, double full_clearance_m, const Executor& executor) {
    std::vector<double> openness(leaves.nodes.size());
    for (std::size_t node = 0; node < leaves.nodes.size(); ++node) {
        const Leaf& leaf = leaves.table.leaf(leaves.nodes[node]);
        const std::int32_t half = leaf.side_cells() / 2;
        const Cell centre{leaf.lower_left.x + half, leaf.lower_left.y + half};
        openness[node] =
            std::min<double>(clearance.at(centre), full_clearance_m) / full_clearance_m;
    }
    std::vector<WeightedEdge> edges = border_edges(leaves.table, leaves.nodes, executor);
    for (WeightedEdge& edge : edges) edge.weight *= std::min(openness[edge.a], openness[edge.b]);
    return build_graph(edges, leaf_areas_m2(leaves.table, leaves.nodes, resolution_m));
}

/// The spectral over-cut, its borders moved to the narrowest lines.
Basins spectral_pieces(const GridMap& open_map, const Raster<float>& clearance,
                       const RoomsOptions& options, std::uint64_t seed, StageClock& clock,
                       const Executor& executor, CutReport& report) {
    clock.begin("map");
    const FreeLeaves leaves = free_leaves(open_map);
    clock.begin("graph");
    const Graph graph = narrowness_graph(leaves, clearance, open_map.resolution_m,
                                         options.full_clearance_m, executor);
    OverCutOptions over_cut_options;
    over_cut_options.max_eigenvalue_per_m2 = options.max_eigenvalue_per_m2;
    over_cut_options.laplacian = options.laplacian;
    over_cut_options.seed = seed;
    Pieces pieces = over_cut(graph, over_cut_options, clock, executor);
    report.num_leaves = leaves.nodes.size();
    report.num_edges = num_edges(graph);
    report.eigen = std::move(pieces.eigen);
    clock.begin("snap");
    return snap_to_basins(build_basins(clearance, open_map.resolution_m, executor), leaves.table,
                          leaves.nodes, pieces.piece_of_node);
}

}  // namespace

Basins find_pieces(Raster<std::uint8_t> open, const Raster<float>& clearance, double resolution_m,
                   const RoomsOptions& options, std::uint64_t seed, StageClock& clock,
                   const Executor& executor, CutReport& report) {
    if (options.pieces == PieceSource::basins) {
        clock.begin("cut");
        open = {};  // The basins are the memory's peak.
        return build_basins(clearance, resolution_m, executor);
    }
    return spectral_pieces(map_of(open, resolution_m), clearance, options, seed, clock, executor,
                           report);
}

}  // namespace quadcut
