// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/room_graph.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace quadcut {
namespace {

constexpr std::int32_t side_x(unsigned bit) { return (bit & 1U) != 0 ? 1 : -1; }
constexpr std::int32_t side_y(unsigned bit) { return (bit & 2U) != 0 ? 1 : -1; }

std::uint8_t blocked_around(const RobotFloor& floor, Cell cell) {
    unsigned blocked = 0;
    for (unsigned bit = 0; bit < 4; ++bit) {
        const Cell corner{cell.x + side_x(bit), cell.y + side_y(bit)};
        if (!floor.fits(corner) && floor.fits({corner.x, cell.y}) &&
            floor.fits({cell.x, corner.y})) {
            blocked |= 1U << bit;
        }
    }
    return static_cast<std::uint8_t>(blocked);
}

void connect(const RobotFloor& floor, RoomGraph& graph) {
    Sight sight(floor);
    std::vector<std::vector<RoomGraph::Edge>> edges(graph.nodes.size());
    for (std::uint32_t i = 0; i < graph.nodes.size(); ++i) {
        const WayNode& a = graph.nodes[i];
        const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(i, graph.first_hub));
        for (std::uint32_t j = 0; j < last; ++j) {
            const WayNode& b = graph.nodes[j];
            if (!is_taut(a, b.cell) || !is_taut(b, a.cell) || !sight.sees(a.cell, b.cell)) continue;
            const float length = cells_between(a.cell, b.cell);
            edges[i].push_back({j, length});
            if (i < graph.first_hub) edges[j].push_back({i, length});
        }
    }
    for (const std::vector<RoomGraph::Edge>& of_node : edges) {
        graph.first_edge.push_back(graph.edges.size());
        graph.edges.insert(graph.edges.end(), of_node.begin(), of_node.end());
    }
    graph.first_edge.push_back(graph.edges.size());
    graph.num_cells_read = sight.num_cells();
}

/// Dijkstra.
void measure_from(std::uint32_t crossing, RoomGraph& graph) {
    using Entry = std::pair<float, std::uint32_t>;
    float* const lengths = graph.lengths.data() + graph.entry(crossing, 0);
    std::uint32_t* const previous = graph.previous.data() + graph.entry(crossing, 0);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    lengths[crossing] = 0.0F;
    queue.push({0.0F, crossing});
    while (!queue.empty()) {
        const auto [length, node] = queue.top();
        queue.pop();
        if (length > lengths[node]) continue;
        for (std::size_t i = graph.first_edge[node]; i < graph.first_edge[node + 1U]; ++i) {
            const RoomGraph::Edge edge = graph.edges[i];
            if (length + edge.length >= lengths[edge.to]) continue;
            lengths[edge.to] = length + edge.length;
            previous[edge.to] = node;
            queue.push({lengths[edge.to], edge.to});
        }
    }
    for (std::size_t hub = graph.first_hub; hub < graph.nodes.size(); ++hub) {
        for (std::size_t i = graph.first_edge[hub]; i < graph.first_edge[hub + 1]; ++i) {
            const RoomGraph::Edge edge = graph.edges[i];
            if (lengths[edge.to] + edge.length >= lengths[hub]) continue;
            lengths[hub] = lengths[edge.to] + edge.length;
            previous[hub] = edge.to;
        }
    }
}

/// Away from the obstacles' corners, where the robot fits there, too.
Cell moved_off(const RobotFloor& floor, Cell cell, std::uint8_t blocked) {
    Cell off = cell;
    for (unsigned bit = 0; bit < 4; ++bit) {
        if ((blocked >> bit & 1U) != 0) off = {off.x - side_x(bit), off.y - side_y(bit)};
    }
    const bool is_same_room = floor.fits(off) && floor.labels.at(off) == floor.labels.at(cell);
    return is_same_room ? off : cell;
}

}  // namespace

std::vector<std::vector<WayNode>> find_corners(const RobotFloor& floor, std::size_t num_rooms) {
    std::vector<std::vector<WayNode>> corners(num_rooms);
    for_each_cell(floor.labels.box(), [&](Cell cell) {
        if (!floor.fits(cell)) return;
        const std::uint8_t blocked = blocked_around(floor, cell);
        if (blocked == 0) return;
        corners[floor.labels.at(cell) - std::size_t{1}].push_back(
            {moved_off(floor, cell, blocked), blocked});
    });
    for (std::vector<WayNode>& of_room : corners) {
        std::stable_sort(of_room.begin(), of_room.end(),
                         [](const WayNode& a, const WayNode& b) { return a.cell.y < b.cell.y; });
    }
    return corners;
}

std::vector<std::vector<Cell>> find_hubs(const RobotFloor& floor, std::size_t num_rooms) {
    std::vector<std::vector<Cell>> hubs(num_rooms);
    const Box all = floor.labels.box();
    for (Cell tile = all.low; tile.y <= all.high.y; tile.y += kHubTile) {
        for (tile.x = all.low.x; tile.x <= all.high.x; tile.x += kHubTile) {
            std::map<std::uint16_t, Cell> best;
            const Box box{tile, {tile.x + kHubTile - 1, tile.y + kHubTile - 1}};
            for_each_cell(box.intersected(all), [&](Cell cell) {
                if (!floor.fits(cell)) return;
                const auto [at, is_new] = best.try_emplace(floor.labels.at(cell), cell);
                if (floor.clearance_m.at(cell) > floor.clearance_m.at(at->second)) {
                    at->second = cell;
                }
            });
            for (const auto& [label, cell] : best) hubs[label - std::size_t{1}].push_back(cell);
        }
    }
    return hubs;
}

bool is_taut(const WayNode& node, Cell towards) {
    if (node.blocked == 0) return true;
    const std::int32_t x = towards.x - node.cell.x;
    const std::int32_t y = towards.y - node.cell.y;
    for (unsigned bit = 0; bit < 4; ++bit) {
        if ((node.blocked >> bit & 1U) == 0) continue;
        const std::int32_t to_corner = x * side_x(bit);
        const std::int32_t beside = y * side_y(bit);
        // Past the obstacle's corner: neither into it nor straight away from it.
        if ((to_corner >= 0 && beside <= 0) || (to_corner <= 0 && beside >= 0)) return true;
    }
    return false;
}

RoomGraph build_room_graph(const RobotFloor& floor, std::vector<WayNode> crossings,
                           const std::vector<WayNode>& corners, const std::vector<Cell>& hubs) {
    RoomGraph graph;
    graph.num_crossings = crossings.size();
    graph.nodes = std::move(crossings);
    graph.nodes.insert(graph.nodes.end(), corners.begin(), corners.end());
    graph.first_hub = graph.nodes.size();
    for (const Cell hub : hubs) graph.nodes.push_back({hub, 0});
    connect(floor, graph);
    const std::size_t num_entries = graph.num_crossings * graph.nodes.size();
    graph.lengths.assign(num_entries, std::numeric_limits<float>::infinity());
    graph.previous.assign(num_entries, 0);
    for (std::uint32_t i = 0; i < graph.num_crossings; ++i) measure_from(i, graph);
    return graph;
}

}  // namespace quadcut
