// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/segment.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"
#include "quadcut/graph/border_edges.hpp"
#include "quadcut/graph/visibility.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/segment/basins.hpp"
#include "quadcut/segment/cut.hpp"
#include "quadcut/segment/describe.hpp"
#include "quadcut/segment/doors.hpp"
#include "quadcut/segment/find_submaps.hpp"
#include "quadcut/segment/free_leaves.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/open_space.hpp"
#include "quadcut/segment/region_graph.hpp"
#include "quadcut/segment/rooms.hpp"
#include "quadcut/segment/snap.hpp"

namespace quadcut {
namespace {

/// Narrower openings are gaps in the map.
constexpr double kMinDoorM = 0.3;

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

/// Each edge stands in two rows; loops are no edges.
std::size_t num_edges(const Graph& graph) {
    std::size_t num_entries = 0;
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        for (const std::uint32_t next : graph.neighbours(node)) {
            if (next != node) ++num_entries;
        }
    }
    return num_entries / 2;
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

/// Numbers, doors and descriptions: what both presets end with.
void complete(Raster<std::uint32_t> labels, const GridMap& map, const Raster<float>& clearance,
              StageClock& clock, const Executor& executor, Segmentation& result) {
    clock.begin("doors");
    const std::uint32_t count = number_in_reading_order(labels);
    if (count > kMaxRoomId) {
        throw InputError("the map has " + std::to_string(count) +
                         " rooms: expected at most 65535, the range of a label");
    }
    result.doors = find_doors(labels, count, clearance, map.resolution_m, map.map_from_image,
                              kMinDoorM, executor);
    result.rooms = describe_rooms(labels, count, map, result.doors, executor);
    result.next_id = count + 1;
    result.labels = Raster<std::uint16_t>(labels.origin, labels.width, labels.height);
    std::transform(labels.values.begin(), labels.values.end(), result.labels.values.begin(),
                   [](std::uint32_t label) { return static_cast<std::uint16_t>(label); });
}

/// The spectral over-cut as labels.
Basins paint(const Pieces& pieces, const FreeLeaves& leaves, const Raster<float>& clearance) {
    Basins painted{Raster<std::uint32_t>(clearance.origin, clearance.width, clearance.height),
                   static_cast<std::uint32_t>(pieces.count)};
    for (std::size_t node = 0; node < leaves.nodes.size(); ++node) {
        const Leaf& leaf = leaves.table.leaf(leaves.nodes[node]);
        paint_leaf(leaf, pieces.piece_of_node[node] + 1, painted.labels);
    }
    return painted;
}

/// The spectral over-cut; its borders are moved to the narrowest lines unless they are to stay.
Basins spectral_pieces(const GridMap& open_map, const Raster<float>& clearance,
                       const SegmentOptions& options, StageClock& clock, const Executor& executor,
                       SegmentReport& report) {
    clock.begin("map");
    const FreeLeaves leaves = free_leaves(open_map);
    clock.begin("graph");
    const Graph graph = narrowness_graph(leaves, clearance, open_map.resolution_m,
                                         options.rooms.full_clearance_m, executor);
    OverCutOptions over_cut_options;
    over_cut_options.max_eigenvalue_per_m2 = options.rooms.max_eigenvalue_per_m2;
    over_cut_options.laplacian = options.rooms.laplacian;
    over_cut_options.seed = options.seed;
    Pieces pieces = over_cut(graph, over_cut_options, clock, executor);
    report.num_leaves = leaves.nodes.size();
    report.num_edges = num_edges(graph);
    report.eigen = std::move(pieces.eigen);
    if (options.rooms.pieces == PieceSource::unsnapped) return paint(pieces, leaves, clearance);
    clock.begin("snap");
    return snap_to_basins(build_basins(clearance, open_map.resolution_m, executor), leaves.table,
                          leaves.nodes, pieces.piece_of_node);
}

Basins find_pieces(const Raster<std::uint8_t>& open, const Raster<float>& clearance,
                   double resolution_m, const SegmentOptions& options, StageClock& clock,
                   const Executor& executor, SegmentReport& report) {
    if (options.rooms.pieces == PieceSource::basins) {
        clock.begin("cut");
        return build_basins(clearance, resolution_m, executor);
    }
    return spectral_pieces(map_of(open, resolution_m), clearance, options, clock, executor, report);
}

Segmentation segment_rooms(const GridMap& map, const SegmentOptions& options,
                           std::span<const Point> trajectory, StageClock& clock,
                           const Executor& executor) {
    Segmentation result;
    // 1. What is cut: connected free space, without specks and without the ground outside, laid
    //    out so that the result does not depend on how the map lies.
    clock.begin("inside");
    const Raster<std::uint8_t> kept_in_map =
        inside(map, trajectory, options.rooms.min_component_m2);
    const Layout layout = standard_layout(kept_in_map);
    const auto kept = laid_out<std::uint8_t>(kept_in_map, layout, 0);
    // 2. Clearance, in which furniture does not count.
    clock.begin("clearance");
    const Raster<std::uint8_t> open = open_space(
        kept, map.resolution_m, options.rooms.max_furniture_m2, options.rooms.furniture, executor);
    const Raster<float> clearance = clearance_m(open, map.resolution_m, executor);
    // 3. Pieces: the basins of the clearance, or the spectral over-cut of the quadtree's leaves.
    const Basins pieces =
        find_pieces(open, clearance, map.resolution_m, options, clock, executor, result.report);
    // 4. Pieces are fused into rooms.
    const auto free = laid_out<std::uint8_t>(mask_of(map, CellState::free), layout, 0);
    clock.begin("graph");
    RegionGraph regions(pieces.labels, pieces.count, clearance, map.resolution_m);
    if (options.rooms.pieces == PieceSource::basins) {
        result.report.num_leaves = pieces.count;
        result.report.num_edges = regions.num_saddles();
    }
    clock.begin("fuse");
    Hierarchy* const hierarchy = options.with_hierarchy ? &result.hierarchy : nullptr;
    const Raster<std::uint32_t> rooms =
        fuse_into_rooms({pieces.labels, clearance, free, map.resolution_m}, options.rooms, {},
                        executor, regions, hierarchy);

    Raster<std::uint32_t> labels(map.states.origin, map.states.width, map.states.height);
    Raster<float> clearance_in_map(map.states.origin, map.states.width, map.states.height);
    put_back(rooms, layout, labels);
    put_back(clearance, layout, clearance_in_map);
    if (options.with_hierarchy) {
        Raster<std::uint16_t> finest(map.states.origin, map.states.width, map.states.height);
        put_back(result.hierarchy.finest, layout, finest);
        result.hierarchy.finest = std::move(finest);
    }
    complete(std::move(labels), map, clearance_in_map, clock, executor, result);
    return result;
}

/// Inside and outside: a submap that the trajectory does not cross is no part of the map.
Raster<std::uint32_t> paint_submaps(const GridMap& map, const FreeLeaves& leaves,
                                    std::span<const std::uint32_t> nodes, const Pieces& pieces,
                                    std::span<const Point> trajectory) {
    Raster<std::uint32_t> labels(map.states.origin, map.states.width, map.states.height);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Leaf& leaf = leaves.table.leaf(leaves.nodes[nodes[i]]);
        paint_leaf(leaf, pieces.piece_of_node[i] + 1, labels);
    }
    if (trajectory.empty()) return labels;
    std::vector<bool> is_crossed(pieces.count + 1, false);
    for (const Cell cell : visited_cells(map, trajectory)) is_crossed[labels.at(cell)] = true;
    for (std::uint32_t& label : labels.values) {
        if (!is_crossed[label]) label = 0;
    }
    return labels;
}

Segmentation segment_paper(const GridMap& map, const PaperOptions& options, std::uint64_t seed,
                           std::span<const Point> trajectory, StageClock& clock,
                           const Executor& executor) {
    Segmentation result;
    // Algorithm 1: the quadtree. Undetected area makes no nodes.
    clock.begin("map");
    const FreeLeaves leaves = free_leaves(map);
    // Algorithm 2, eqs. (2) and (3): the graph of leaves that see each other.
    clock.begin("graph");
    const Graph graph = build_graph(
        sight_edges(leaves.table, leaves.nodes, map.resolution_m, options.self_loops, executor),
        leaf_areas_m2(leaves.table, leaves.nodes, map.resolution_m));
    // Eqs. (4) to (9): the smallest eigenvectors, clustered; division and fusion between submaps.
    const Submaps submaps = find_submaps(graph, options, seed, clock, executor);
    result.report.eigen = submaps.pieces.eigen;
    Raster<std::uint32_t> labels =
        paint_submaps(map, leaves, submaps.nodes, submaps.pieces, trajectory);

    result.report.num_leaves = leaves.nodes.size();
    result.report.num_edges = num_edges(graph);
    clock.begin("clearance");
    const Raster<float> clearance =
        clearance_m(mask_of(map, CellState::free), map.resolution_m, executor);
    complete(std::move(labels), map, clearance, clock, executor, result);
    return result;
}

}  // namespace

Segmentation segment(const GridMap& map, const SegmentOptions& options,
                     std::span<const Point> trajectory, const StageCallback& on_stage) {
    StageClock clock(on_stage);
    const Executor executor{static_cast<int>(options.num_threads)};
    Segmentation result =
        options.preset == Preset::rooms
            ? segment_rooms(map, options, trajectory, clock, executor)
            : segment_paper(map, options.paper, options.seed, trajectory, clock, executor);
    result.report.stages_ms = clock.finish();
    return result;
}

}  // namespace quadcut
