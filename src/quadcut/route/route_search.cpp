// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/route_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>

namespace quadcut {
namespace {

/// How far a way goes from one look at its rooms to the next.
constexpr double kStrideM = 0.25;

/// An end of a way looks for so many hubs.
constexpr std::size_t kMostHubs = 4;

constexpr float kFar = std::numeric_limits<float>::infinity();

using QueueEntry = std::pair<float, std::size_t>;
using Queue = std::priority_queue<QueueEntry, std::vector<QueueEntry>, std::greater<>>;

float length_of(const std::vector<Bend>& way) {
    float length = way.empty() ? kFar : 0.0F;
    for (std::size_t i = 1; i < way.size(); ++i) {
        length += cells_between(way[i - 1].cell, way[i].cell);
    }
    return length;
}

Bend bend_at(const RoomGraph& graph, std::size_t node) {
    const bool is_hub = node >= graph.first_hub;
    return {graph.nodes[node].cell, Bend::kNone,
            is_hub ? static_cast<std::uint32_t>(node) : Bend::kNone};
}

/// The nodes from `node` back to the crossing that the lengths were measured from, both included.
std::vector<Bend> way_back(const RoomGraph& graph, std::size_t crossing, std::uint32_t node) {
    std::vector<Bend> way{bend_at(graph, node)};
    while (node != crossing) {
        node = graph.previous[graph.entry(crossing, node)];
        way.push_back(bend_at(graph, node));
    }
    return way;
}

}  // namespace

std::vector<RouteSearch::Seen> RouteSearch::seen_from(Cell cell, std::size_t room) {
    const RoomGraph& graph = planner_.graph_of(room);
    std::vector<Seen> seen;
    const auto look_at = [&](std::uint32_t node) {
        ++num_entries_;
        const WayNode& at = graph.nodes[node];
        if (!is_taut(at, cell) || !sight_.sees(cell, at.cell)) return false;
        seen.push_back({node, cells_between(cell, at.cell)});
        return true;
    };
    std::size_t num_hubs = 0;
    for (const std::uint32_t hub : planner_.hubs_around(cell, room)) {
        if (num_hubs < kMostHubs && look_at(hub)) ++num_hubs;
    }
    if (num_hubs == 0) {
        for (std::uint32_t i = 0; i < graph.first_hub; ++i) look_at(i);
        return seen;
    }
    // Between things that stand close together a way begins round corners that no hub sees.
    const auto last = graph.nodes.begin() + static_cast<std::ptrdiff_t>(graph.first_hub);
    auto node = std::lower_bound(
        graph.nodes.begin() + static_cast<std::ptrdiff_t>(graph.num_crossings), last,
        cell.y - kHubTile, [](const WayNode& at, std::int32_t y) { return at.cell.y < y; });
    for (; node != last && node->cell.y <= cell.y + kHubTile; ++node) {
        if (std::abs(node->cell.x - cell.x) > kHubTile) continue;
        look_at(static_cast<std::uint32_t>(node - graph.nodes.begin()));
    }
    return seen;
}

RouteSearch::End RouteSearch::look_around(Cell cell) {
    End end{cell, planner_.floor_.labels.at(cell) - std::size_t{1}, {}, {}};
    end.seen = seen_from(cell, end.room);
    const RoomGraph& graph = planner_.graph_of(end.room);
    for (std::size_t c = 0; c < graph.num_crossings; ++c) {
        Seen best{0, kFar};
        for (const Seen& seen : end.seen) {
            ++num_entries_;
            const float length = seen.length + graph.lengths[graph.entry(c, seen.node)];
            if (length < best.length) best = {seen.node, length};
        }
        end.to_crossing.push_back(best);
    }
    return end;
}

std::vector<Bend> RouteSearch::way_within(const End& from, const End& to) {
    if (sight_.sees(from.cell, to.cell)) return {{from.cell}, {to.cell}};
    const RoomGraph& graph = planner_.graph_of(from.room);
    const auto edges_of = [&graph](std::size_t node) {
        return std::span(graph.edges)
            .subspan(graph.first_edge[node], graph.first_edge[node + 1] - graph.first_edge[node]);
    };
    const std::size_t goal = graph.nodes.size();
    std::vector<float> lengths(goal + 1, kFar);
    std::vector<std::size_t> previous(goal + 1, goal);
    // What sees the goal, or the hub that sees it, and this hub.
    std::vector<Seen> to_goal(goal, Seen{0, kFar});
    for (const Seen& seen : to.seen) {
        to_goal[seen.node] = seen;
        for (const RoomGraph::Edge& edge : edges_of(seen.node)) {
            ++num_entries_;
            const float length = seen.length + edge.length;
            if (length < to_goal[edge.to].length) to_goal[edge.to] = {seen.node, length};
        }
    }
    Queue queue;
    const auto reach = [&](std::size_t node, float length, std::size_t before) {
        ++num_entries_;
        if (length >= lengths[node]) return;
        lengths[node] = length;
        previous[node] = before;
        const float left = node == goal ? 0.0F : cells_between(graph.nodes[node].cell, to.cell);
        queue.push({length + left, node});
    };
    for (const Seen& seen : from.seen) reach(seen.node, seen.length, goal);
    while (!queue.empty() && queue.top().second != goal) {
        const std::size_t node = queue.top().second;
        queue.pop();
        if (to_goal[node].length != kFar) reach(goal, lengths[node] + to_goal[node].length, node);
        for (const RoomGraph::Edge& edge : edges_of(node)) {
            reach(edge.to, lengths[node] + edge.length, node);
        }
    }
    if (queue.empty()) return {};
    std::vector<Bend> way{{to.cell}, bend_at(graph, to_goal[previous[goal]].node)};
    for (std::size_t node = previous[goal]; node != goal; node = previous[node]) {
        way.push_back(bend_at(graph, node));
    }
    way.push_back({from.cell});
    std::reverse(way.begin(), way.end());
    return way;
}

std::vector<RouteSearch::Exit> RouteSearch::find_exits(const End& from, const End& to,
                                                       float limit) {
    const auto& crossings = planner_.crossings_;
    std::vector<std::size_t> first_exit{0};
    for (const auto& of_room : crossings) first_exit.push_back(first_exit.back() + of_room.size());
    const std::size_t num_exits = first_exit.back();
    std::vector<Exit> exits;
    for (std::size_t room = 0; room < crossings.size(); ++room) {
        for (std::uint32_t i = 0; i < crossings[room].size(); ++i) exits.push_back({room, i});
    }
    std::vector<float> lengths(num_exits, kFar);
    std::vector<std::size_t> previous(num_exits, num_exits);
    Queue queue;
    const auto reach = [&](std::size_t room, std::size_t crossing, float length,
                           std::size_t before) {
        const std::size_t exit = first_exit[room] + crossing;
        ++num_entries_;
        if (length >= lengths[exit]) return;
        const RoutePlanner::Crossing& at = crossings[room][crossing];
        const Cell cell = planner_.gates_[at.gate].border[at.place][at.side];
        lengths[exit] = length;
        previous[exit] = before;
        queue.push({length + cells_between(cell, to.cell), exit});
    };
    for (std::size_t i = 0; i < from.to_crossing.size(); ++i) {
        reach(from.room, i, from.to_crossing[i].length, num_exits);
    }
    std::size_t last = num_exits;
    while (!queue.empty() && queue.top().first < limit) {
        const auto [bound, exit] = queue.top();
        queue.pop();
        const auto [room, crossing] = exits[exit];
        const RoutePlanner::Crossing& left = crossings[room][crossing];
        const auto& rooms = planner_.gates_[left.gate].rooms;
        const std::size_t next = rooms[1 - left.side] - std::size_t{1};
        const float length = lengths[exit] + 1.0F;
        if (next == to.room && length + to.to_crossing[left.beyond].length < limit) {
            limit = length + to.to_crossing[left.beyond].length;
            last = exit;
        }
        // Whoever came to this place from within the room goes on from it no longer.
        if (lengths[first_exit[next] + left.beyond] <= length) continue;
        const RoomGraph& graph = planner_.graph_of(next);
        for (std::size_t i = 0; i < graph.num_crossings; ++i) {
            if (i == left.beyond) continue;
            reach(next, i, length + graph.lengths[graph.entry(left.beyond, i)], exit);
        }
    }
    std::vector<Exit> way;
    for (; last != num_exits; last = previous[last]) way.push_back(exits[last]);
    std::reverse(way.begin(), way.end());
    return way;
}

std::vector<Bend> RouteSearch::bends_of(const std::vector<Exit>& exits, const End& from,
                                        const End& to) {
    std::vector<Bend> way{{from.cell}};
    const auto append = [&way](std::vector<Bend> more) {
        way.insert(way.end(), more.begin(), more.end());
    };
    for (std::size_t i = 0; i < exits.size(); ++i) {
        const auto [room, crossing] = exits[i];
        const RoutePlanner::Crossing& left = planner_.crossings_[room][crossing];
        const RoomGraph& graph = planner_.graph_of(room);
        if (i == 0) {
            append(way_back(graph, crossing, from.to_crossing[crossing].node));
        } else {
            const Exit& before = exits[i - 1];
            const std::size_t entered = planner_.crossings_[before.room][before.crossing].beyond;
            std::vector<Bend> leg = way_back(graph, entered, crossing);
            std::reverse(leg.begin(), leg.end());
            append(std::move(leg));
        }
        way.back().gate = left.gate;
        if (i + 1 == exits.size()) {
            const RoomGraph& last = planner_.graph_of(to.room);
            std::vector<Bend> leg = way_back(last, left.beyond, to.to_crossing[left.beyond].node);
            std::reverse(leg.begin(), leg.end());
            append(std::move(leg));
        }
    }
    way.push_back({to.cell});
    return way;
}

void RouteSearch::round_corner(std::vector<Bend>& way, std::size_t place, const RoomGraph& graph) {
    const std::uint32_t hub = way[place].hub;
    if (hub == Bend::kNone || place == 0 || place + 1 >= way.size()) return;
    const Cell before = way[place - 1].cell;
    const Cell after = way[place + 1].cell;
    if (sight_.sees(before, after)) return;
    std::vector<Seen> corners;
    const float longest =
        cells_between(before, way[place].cell) + cells_between(way[place].cell, after);
    for (std::size_t i = graph.first_edge[hub]; i < graph.first_edge[hub + 1U]; ++i) {
        ++num_entries_;
        const Cell cell = graph.nodes[graph.edges[i].to].cell;
        const float length = cells_between(before, cell) + cells_between(cell, after);
        if (length < longest) corners.push_back({graph.edges[i].to, length});
    }
    std::sort(corners.begin(), corners.end(),
              [](const Seen& a, const Seen& b) { return a.length < b.length; });
    for (const Seen& corner : corners) {
        const Cell cell = graph.nodes[corner.node].cell;
        if (!sight_.sees(before, cell) || !sight_.sees(cell, after)) continue;
        way[place] = {cell};
        return;
    }
}

std::optional<Route> RouteSearch::find(Cell from_cell, Cell to_cell) {
    const End from = look_around(from_cell);
    const End to = look_around(to_cell);
    std::vector<Bend> way;
    if (from.room == to.room) way = way_within(from, to);
    const std::vector<Exit> exits = find_exits(from, to, length_of(way));
    if (!exits.empty()) way = bends_of(exits, from, to);
    if (way.empty()) return std::nullopt;
    round_corner(way, 1, planner_.graph_of(from.room));
    round_corner(way, way.size() - 2, planner_.graph_of(to.room));
    return route_of(pull_straight(std::move(way), planner_.gates_, sight_,
                                  static_cast<double>(planner_.floor_.radius_m)));
}

void RouteSearch::note_step(std::uint16_t label, std::uint16_t next, Cell cell,
                            Route& route) const {
    const std::vector<Room>& rooms = planner_.rooms_.rooms;
    const Point at = planner_.middle_of(cell);
    RouteStep step{rooms[label - std::size_t{1}].id, rooms[next - std::size_t{1}].id, std::nullopt,
                   at, route.length_m + distance(route.points.back(), at)};
    // Where a border is crossed to and fro the way keeps to one side of it.
    constexpr double kVisitM = 0.5;
    if (!route.steps.empty() && route.steps.back().from == step.to &&
        distance(route.steps.back().at, step.at) < kVisitM) {
        route.steps.pop_back();
        return;
    }
    double nearest_m = 1.0;
    for (std::size_t i = 0; i < planner_.rooms_.doors.size(); ++i) {
        const Door& door = planner_.rooms_.doors[i];
        const bool is_between = (door.a == step.from && door.b == step.to) ||
                                (door.a == step.to && door.b == step.from);
        if (!is_between) continue;
        const Point middle{(door.jamb_1.x + door.jamb_2.x) / 2.0,
                           (door.jamb_1.y + door.jamb_2.y) / 2.0};
        const double away_m = distance(middle, step.at) - door.width_m / 2.0;
        if (away_m >= nearest_m) continue;
        nearest_m = away_m;
        step.door = i;
    }
    route.steps.push_back(step);
}

void RouteSearch::note_steps(Cell from, Cell to, Route& route) {
    const Raster<std::uint16_t>& labels = planner_.floor_.labels;
    const std::int32_t length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const auto cell_at = [&](std::int32_t i) {
        const double share = static_cast<double>(i) / std::max(length, 1);
        return Cell{from.x + static_cast<std::int32_t>(std::lround((to.x - from.x) * share)),
                    from.y + static_cast<std::int32_t>(std::lround((to.y - from.y) * share))};
    };
    const auto label_at = [&](std::int32_t i) {
        ++route.num_cells_read;
        return labels.at(cell_at(i));
    };
    const auto stride =
        std::max(1, static_cast<std::int32_t>(kStrideM / planner_.floor_.resolution_m));
    std::uint16_t label = label_at(0);
    for (std::int32_t i = 0; i < length;) {
        std::int32_t high = std::min(i + stride, length);
        const std::uint16_t next = label_at(high);
        const std::int32_t end = high;
        // The first cell of the next room, by halves.
        for (std::int32_t low = i; next != label && low + 1 < high;) {
            const std::int32_t middle = (low + high) / 2;
            (label_at(middle) == next ? high : low) = middle;
        }
        if (next != label) note_step(label, next, cell_at(high), route);
        label = next;
        i = end;
    }
}

Route RouteSearch::route_of(const std::vector<Bend>& way) {
    Route route;
    const std::uint16_t label = planner_.floor_.labels.at(way.front().cell);
    route.first_room = planner_.rooms_.rooms[label - std::size_t{1}].id;
    route.points.push_back(planner_.middle_of(way.front().cell));
    for (std::size_t i = 1; i < way.size(); ++i) {
        note_steps(way[i - 1].cell, way[i].cell, route);
        route.points.push_back(planner_.middle_of(way[i].cell));
        route.length_m += distance(route.points[i - 1], route.points[i]);
    }
    route.num_cells_read += sight_.num_cells();
    route.num_entries_read = num_entries_;
    return route;
}

}  // namespace quadcut
