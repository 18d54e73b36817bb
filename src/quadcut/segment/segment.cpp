// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/segment.hpp"

#include <algorithm>
#include <cmath>
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
#include "quadcut/rooms/glimpses.hpp"
#include "quadcut/rooms/hierarchy.hpp"
#include "quadcut/rooms/previous.hpp"
#include "quadcut/rooms/regions.hpp"
#include "quadcut/rooms/rooms.hpp"
#include "quadcut/segment/floor.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/reading_order.hpp"

namespace quadcut {
namespace {

/// Numbers, doors and descriptions: what both presets end with. The rasters and `way` are laid out.
void complete(Raster<std::uint32_t> labels, const Ground& ground, const GridMap& map,
              const Layout& layout, std::span<const Cell> way, StageClock& clock,
              const Executor& executor, Segmentation& result) {
    clock.begin("doors");
    const std::uint32_t count = number_by_first_cells(labels, layout, executor);
    if (count > kMaxRoomId) {
        throw InputError("the map has " + std::to_string(count) +
                         " rooms: expected at most 65535, the range of a label");
    }
    result.doors = find_doors(labels, count, ground, {layout, map.resolution_m, map.map_from_image},
                              kMinDoorM, executor);
    result.rooms = describe_rooms(labels, count, map, layout, result.doors, executor);
    judge_seen(result.rooms, labels, map.states, layout, map.resolution_m, result.doors, way,
               executor);
    result.next_id = count + 1;
    result.labels =
        Raster<std::uint16_t>(map.states.origin, map.states.width, map.states.height, 0, executor);
    for_each_laid_out(result.labels, layout, executor, [&](std::size_t from, std::size_t to) {
        result.labels.values[to] = static_cast<std::uint16_t>(labels.values[from]);
    });
    number_in_reading_order(result, map, executor);
}

/// Where the robot was, laid out.
std::vector<Cell> way_in(const Layout& layout, const GridMap& map,
                         std::span<const Point> trajectory) {
    std::vector<Cell> way = visited_cells(map, trajectory);
    for (Cell& cell : way) cell = layout.place_of(cell);
    return way;
}

Segmentation segment_rooms(const GridMap& map, const SegmentOptions& options,
                           std::span<const Point> trajectory, const Raster<std::uint16_t>& earlier,
                           StageClock& clock, const Executor& executor) {
    Segmentation result;
    clock.begin("inside");
    Floor floor = lay_out_floor(map, trajectory, options.rooms.min_component_m2, executor);
    Hierarchy* const hierarchy = options.with_hierarchy ? &result.hierarchy : nullptr;
    const std::vector<Cell> way = way_in(floor.layout, map, trajectory);
    FloorToCut to_cut{
        std::move(floor.kept), floor.states, map.resolution_m, {}, options.paper.num_submaps};
    if (!earlier.values.empty()) {
        const Raster<std::uint16_t> there = rooms_still_there(earlier, map.states);
        if (there.values.empty()) {
            result.report.warnings.emplace_back(
                "a quarter of the earlier result's floor or more is not free in this map, so that "
                "it is no evidence: are both in the same map frame?");
        } else {
            to_cut.earlier = laid_out<std::uint16_t>(there, floor.layout, 0, executor);
        }
    }
    RoomsCut cut = cut_into_rooms(std::move(to_cut), options.rooms, clock, executor, hierarchy);
    static_cast<CutReport&>(result.report) = std::move(cut.report);
    drop_outside(cut.rooms, floor.layout, map.states.box(), way);
    split_off_fans(cut.rooms, cut.clearance_m, map.states, floor.layout, map.resolution_m,
                   options.rooms.min_passable_m, options.rooms.min_room_m2, way, executor);
    if (options.with_hierarchy) {
        keep_nested(result.hierarchy, cut.rooms);
        Raster<std::uint16_t> finest(map.states.origin, map.states.width, map.states.height);
        put_back(result.hierarchy.finest, floor.layout, finest, executor);
        result.hierarchy.finest = std::move(finest);
    }
    if (drops_uncrossed(options)) drop_uncrossed(cut.rooms, way);
    const Ground ground{cut.clearance_m, cut.free_clearance_m, floor.states, cut.lines,
                        map.resolution_m};
    complete(std::move(cut.rooms), ground, map, floor.layout, way, clock, executor, result);
    return result;
}

/// The map on the cells of its frame: a place has the same quadtree wherever its image begins.
GridMap on_cells_of_frame(const GridMap& map) {
    GridMap placed = map;
    const auto cell = [&](double at_m) {
        return static_cast<std::int32_t>(std::llround(at_m / map.resolution_m));
    };
    placed.states.origin = {cell(map.map_from_image.x), cell(map.map_from_image.y)};
    return placed;
}

Raster<std::uint32_t> paint_submaps(const Box& box, const FreeLeaves& leaves,
                                    const Submaps& submaps) {
    Raster<std::uint32_t> labels(box);
    for (std::size_t i = 0; i < submaps.nodes.size(); ++i) {
        const Leaf& leaf = leaves.table.leaf(leaves.nodes[submaps.nodes[i]]);
        paint_leaf(leaf, submaps.pieces.piece_of_node[i] + 1, labels);
    }
    labels.origin = {0, 0};
    return labels;
}

Segmentation segment_paper(const GridMap& map, const SegmentOptions& all_options,
                           std::span<const Point> trajectory, StageClock& clock,
                           const Executor& executor) {
    const PaperOptions& options = all_options.paper;
    Segmentation result;
    // Algorithm 1: the quadtree. Undetected area makes no nodes.
    clock.begin("map");
    const GridMap placed = on_cells_of_frame(map);
    const FreeLeaves leaves = free_leaves(placed);
    // Algorithm 2, eqs. (2) and (3): the graph of leaves that see each other.
    clock.begin("graph");
    const Graph graph = build_graph(
        sight_edges(leaves.table, leaves.nodes, map.resolution_m, options.self_loops, executor),
        leaf_areas_m2(leaves.table, leaves.nodes, map.resolution_m));
    // Eqs. (4) to (9): the smallest eigenvectors, clustered; division and fusion between submaps.
    const Submaps submaps = find_submaps(graph, options, all_options.seed, clock, executor);
    result.report.eigen = submaps.pieces.eigen;
    Raster<std::uint32_t> labels = paint_submaps(placed.states.box(), leaves, submaps);
    // Leaves that see each other through a slit need not touch.
    connect_regions(labels, {}, executor);
    // Inside and outside: a submap that the trajectory does not cross is no part of the map.
    if (drops_uncrossed(all_options)) drop_uncrossed(labels, visited_cells(map, trajectory));

    result.report.num_leaves = leaves.nodes.size();
    result.report.num_edges = num_edges(graph);
    clock.begin("clearance");
    Raster<float> clearance =
        clearance_m(mask_of(map, CellState::free), map.resolution_m, executor);
    clearance.origin = {0, 0};
    const WallLines no_lines;
    const Layout layout = as_it_lies(map.states.box());
    const Ground ground{clearance, clearance, map.states, no_lines, map.resolution_m};
    complete(std::move(labels), ground, map, layout, way_in(layout, map, trajectory), clock,
             executor, result);
    return result;
}

}  // namespace

Segmentation segment(const GridMap& map, const SegmentOptions& options, const RunOptions& run,
                     std::span<const Point> trajectory, const Raster<std::uint16_t>& earlier) {
    StageClock clock(run.on_stage);
    const Executor executor = run.executor();
    Segmentation result = options.preset == Preset::rooms
                              ? segment_rooms(map, options, trajectory, earlier, clock, executor)
                              : segment_paper(map, options, trajectory, clock, executor);
    result.report.stages_ms = clock.finish();
    return result;
}

Segmentation segment(const GridMap& map) { return segment(map, SegmentOptions{}); }

}  // namespace quadcut
