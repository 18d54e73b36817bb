// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/segment.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/submaps.hpp"
#include "quadcut/paper/visibility.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/rooms/doors.hpp"
#include "quadcut/rooms/rooms.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/reading_order.hpp"

namespace quadcut {
namespace {

/// Numbers, doors and descriptions: what both presets end with. The rasters are laid out.
void complete(Raster<std::uint32_t> labels, Raster<float> clearance, const GridMap& map,
              const Layout& layout, StageClock& clock, const Executor& executor,
              Segmentation& result) {
    clock.begin("doors");
    const std::uint32_t count = number_by_first_cells(labels, layout, executor);
    if (count > kMaxRoomId) {
        throw InputError("the map has " + std::to_string(count) +
                         " rooms: expected at most 65535, the range of a label");
    }
    result.doors = find_doors(labels, count, clearance,
                              {layout, map.resolution_m, map.map_from_image}, kMinDoorM, executor);
    result.rooms =
        describe_rooms(labels, count, map, layout, result.doors, executor, std::move(clearance));
    result.next_id = count + 1;
    result.labels =
        Raster<std::uint16_t>(map.states.origin, map.states.width, map.states.height, 0, executor);
    for_each_laid_out(result.labels, layout, executor, [&](std::size_t from, std::size_t to) {
        result.labels.values[to] = static_cast<std::uint16_t>(labels.values[from]);
    });
    number_in_reading_order(result, map, executor);
}

/// What is cut: connected free space, without specks and without the ground outside, laid out so
/// that the result does not depend on how the map lies.
struct Floor {
    Layout layout;
    Raster<std::uint8_t> kept;
    Raster<std::uint8_t> free;
};

Floor lay_out_floor(const GridMap& map, std::span<const Point> trajectory, double min_component_m2,
                    const Executor& executor) {
    Floor floor;
    const Raster<std::uint8_t> kept = inside(map, trajectory, min_component_m2, executor);
    floor.layout = standard_layout(kept, executor);
    floor.kept = laid_out<std::uint8_t>(kept, floor.layout, 0, executor);
    floor.free = Raster<std::uint8_t>(floor.kept.box(), 0, executor);
    for_each_laid_out(map.states, floor.layout, executor, [&](std::size_t to, std::size_t from) {
        floor.free.values[to] = map.states.values[from] == CellState::free ? 1 : 0;
    });
    return floor;
}

Segmentation segment_rooms(const GridMap& map, const SegmentOptions& options,
                           std::span<const Point> trajectory, StageClock& clock,
                           const Executor& executor) {
    Segmentation result;
    clock.begin("inside");
    Floor floor = lay_out_floor(map, trajectory, options.rooms.min_component_m2, executor);
    Hierarchy* const hierarchy = options.with_hierarchy ? &result.hierarchy : nullptr;
    RoomsCut cut = cut_into_rooms(
        {std::move(floor.kept), floor.free, map.resolution_m, {}, options.paper.num_submaps},
        options.rooms, clock, executor, hierarchy);
    static_cast<CutReport&>(result.report) = std::move(cut.report);
    floor.free = {};
    if (options.with_hierarchy) {
        Raster<std::uint16_t> finest(map.states.origin, map.states.width, map.states.height);
        put_back(result.hierarchy.finest, floor.layout, finest, executor);
        result.hierarchy.finest = std::move(finest);
    }
    complete(std::move(cut.rooms), std::move(cut.clearance_m), map, floor.layout, clock, executor,
             result);
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
    Raster<float> clearance =
        clearance_m(mask_of(map, CellState::free), map.resolution_m, executor);
    clearance.origin = labels.origin = {0, 0};
    complete(std::move(labels), std::move(clearance), map, as_it_lies(map.states.box()), clock,
             executor, result);
    return result;
}

}  // namespace

Segmentation segment(const GridMap& map, const SegmentOptions& options, const RunOptions& run,
                     std::span<const Point> trajectory) {
    StageClock clock(run.on_stage);
    const Executor executor = run.executor();
    Segmentation result =
        options.preset == Preset::rooms
            ? segment_rooms(map, options, trajectory, clock, executor)
            : segment_paper(map, options.paper, options.seed, trajectory, clock, executor);
    result.report.stages_ms = clock.finish();
    return result;
}

Segmentation segment(const GridMap& map) { return segment(map, SegmentOptions{}); }

}  // namespace quadcut
