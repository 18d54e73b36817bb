// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/route_planner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/route/route_search.hpp"

namespace quadcut {
namespace {

/// Rooms have the furniture in them that the map has as occupied.
RobotFloor floor_of(const GridMap& map, const Raster<std::uint16_t>& labels, double robot_width_m,
                    const Executor& executor) {
    Raster<std::uint8_t> open = Raster<std::uint8_t>::unset(labels.box());
    const bool has_states = map.states.values.size() == labels.values.size();
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const bool is_taken = has_states && map.states.values[i] == CellState::occupied;
        open.values[i] = labels.values[i] != 0 && !is_taken ? 1 : 0;
    }
    // A robot as narrow as that fits in any cell, and in no obstacle.
    const double least_m = map.resolution_m / 4.0;
    return {labels, clearance_m(open, map.resolution_m, executor), map.resolution_m,
            static_cast<float>(std::max(robot_width_m / 2.0, least_m))};
}

}  // namespace

RoutePlanner::RoutePlanner(const GridMap& map, const Segmentation& rooms, double robot_width_m,
                           const Executor& executor)
    : map_(map),
      rooms_(rooms),
      floor_(floor_of(map, rooms.labels, robot_width_m, executor)),
      parts_(connected_parts(
          floor_.clearance_m,
          [this](std::size_t i) { return floor_.clearance_m.values[i] >= floor_.radius_m ? 1 : 0; },
          Connectivity::four, executor)),
      gates_(find_gates(floor_)),
      crossings_(rooms.rooms.size()),
      corners_(find_corners(floor_, rooms.rooms.size())),
      hubs_(find_hubs(floor_, rooms.rooms.size())),
      graphs_(rooms.rooms.size()) {
    for (std::uint32_t i = 0; i < gates_.size(); ++i) {
        for (const std::uint32_t place : gates_[i].crossings) {
            std::vector<Crossing>& of_a = crossings_[gates_[i].rooms[0] - std::size_t{1}];
            std::vector<Crossing>& of_b = crossings_[gates_[i].rooms[1] - std::size_t{1}];
            of_a.push_back({i, place, 0, static_cast<std::uint32_t>(of_b.size())});
            of_b.push_back({i, place, 1, static_cast<std::uint32_t>(of_a.size() - 1)});
        }
    }
}

RoomGraph RoutePlanner::build_graph(std::size_t room) const {
    std::vector<WayNode> nodes;
    for (const Crossing& crossing : crossings_[room]) {
        nodes.push_back({gates_[crossing.gate].border[crossing.place][crossing.side], 0});
    }
    return build_room_graph(floor_, std::move(nodes), corners_[room], hubs_[room]);
}

const RoomGraph& RoutePlanner::graph_of(std::size_t room) {
    if (!graphs_[room]) graphs_[room] = build_graph(room);
    return *graphs_[room];
}

std::vector<std::uint32_t> RoutePlanner::hubs_around(Cell cell, std::size_t room) const {
    const Cell origin = floor_.labels.origin;
    const auto tile_of = [origin](Cell at) {
        return std::pair{(at.y - origin.y) / kHubTile, (at.x - origin.x) / kHubTile};
    };
    const std::vector<Cell>& hubs = hubs_[room];
    const auto first_hub =
        static_cast<std::uint32_t>(crossings_[room].size() + corners_[room].size());
    std::vector<std::uint32_t> around;
    const auto [row, column] = tile_of(cell);
    for (std::int32_t y = row - 1; y <= row + 1; ++y) {
        const auto first =
            std::lower_bound(hubs.begin(), hubs.end(), std::pair{y, column - 1},
                             [&](Cell hub, const auto& tile) { return tile_of(hub) < tile; });
        for (auto hub = first; hub != hubs.end() && tile_of(*hub) <= std::pair{y, column + 1};
             ++hub) {
            around.push_back(first_hub + static_cast<std::uint32_t>(hub - hubs.begin()));
        }
    }
    std::sort(around.begin(), around.end(), [&](std::uint32_t a, std::uint32_t b) {
        return cells_between(hubs[a - first_hub], cell) < cells_between(hubs[b - first_hub], cell);
    });
    return around;
}

void RoutePlanner::prepare(const Executor& executor) {
    parallel_for(executor, graphs_.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t room = first; room < last; ++room) {
            if (!graphs_[room]) graphs_[room] = build_graph(room);
        }
    });
}

std::optional<Cell> RoutePlanner::standing_place(const Point& point, double within_m) const {
    const Point in_map = transform(inverse(map_.map_from_image), point);
    const Point at{in_map.x / floor_.resolution_m, in_map.y / floor_.resolution_m};
    const double most = 1e9;
    if (!(std::abs(at.x) < most && std::abs(at.y) < most)) return std::nullopt;
    const Cell cell = cell_of(at);
    if (!floor_.labels.contains(cell) || floor_.labels.at(cell) == 0) return std::nullopt;
    if (floor_.fits(cell)) return cell;
    const double within = within_m / floor_.resolution_m;
    std::optional<Cell> nearest;
    double least = within;
    const Box box = Box{cell, cell}.grown(static_cast<std::int32_t>(within) + 1);
    for_each_cell(box.intersected(floor_.labels.box()), [&](Cell next) {
        const double away = std::hypot(next.x + 0.5 - at.x, next.y + 0.5 - at.y);
        if (away > least || !floor_.fits(next) ||
            floor_.labels.at(next) != floor_.labels.at(cell)) {
            return;
        }
        least = away;
        nearest = next;
    });
    return nearest;
}

Point RoutePlanner::middle_of(Cell cell) const {
    return transform(map_.map_from_image,
                     {(cell.x + 0.5) * floor_.resolution_m, (cell.y + 0.5) * floor_.resolution_m});
}

bool RoutePlanner::is_connected(Cell from, Cell to) const {
    const Cell origin = floor_.labels.origin;
    const auto part_of = [&](Cell cell) {
        return parts_.part_at(static_cast<std::uint32_t>(cell.x - origin.x),
                              static_cast<std::size_t>(cell.y - origin.y));
    };
    return part_of(from) == part_of(to);
}

std::optional<Route> RoutePlanner::find(Cell from, Cell to) {
    if (!is_connected(from, to)) return std::nullopt;
    return RouteSearch(*this).find(from, to);
}

std::size_t RoutePlanner::num_cells_prepared() const {
    std::size_t num_cells = 2 * floor_.labels.values.size();
    for (const auto& graph : graphs_) num_cells += graph ? graph->num_cells_read : 0;
    return num_cells;
}

std::size_t RoutePlanner::bytes() const {
    std::size_t bytes = 0;
    for (const auto& graph : graphs_) {
        if (!graph) continue;
        bytes += graph->nodes.size() * sizeof(WayNode) +
                 graph->edges.size() * sizeof(RoomGraph::Edge) +
                 graph->lengths.size() * (sizeof(float) + sizeof(std::uint32_t));
    }
    return bytes;
}

}  // namespace quadcut
