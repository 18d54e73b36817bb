// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/conductance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

/// What is wider lets no more through: people and robots pass one by one, and between wings there
/// are the widest doors.
constexpr double kFullWidthM = 1.0;
/// As which width nearness counts.
constexpr double kNearM = 0.01;

/// How far rooms are apart, as discs of their areas; less than 0 where these overlap.
double distance_m(const Room& a, const Room& b) {
    const double radii =
        (std::sqrt(a.area_m2) + std::sqrt(b.area_m2)) / std::sqrt(std::numbers::pi);
    return std::hypot(a.label_point.x - b.label_point.x, a.label_point.y - b.label_point.y) - radii;
}

/// From each component but the largest, the shortest edge to another one.
std::vector<WeightedEdge> edges_to_nearest(const Graph& graph, std::span<const Room> rooms) {
    const std::vector<std::uint32_t> component = connected_components(graph);
    std::vector<std::size_t> size(component.size(), 0);
    for (const std::uint32_t c : component) ++size[c];
    const auto largest =
        static_cast<std::uint32_t>(std::max_element(size.begin(), size.end()) - size.begin());
    std::map<std::uint32_t, std::pair<double, WeightedEdge>> nearest;
    for (std::uint32_t a = 0; a < rooms.size(); ++a) {
        if (component[a] == largest) continue;
        for (std::uint32_t b = 0; b < rooms.size(); ++b) {
            if (component[b] == component[a]) continue;
            const double apart_m = distance_m(rooms[a], rooms[b]);
            const auto [known, is_first] =
                nearest.try_emplace(component[a], apart_m, WeightedEdge{a, b, kNearM});
            if (!is_first && apart_m < known->second.first) {
                known->second = {apart_m, {a, b, kNearM}};
            }
        }
    }
    std::vector<WeightedEdge> edges;
    for (const auto& [c, edge] : nearest) edges.push_back(edge.second);
    return edges;
}

}  // namespace

Graph conductance_graph(const Segmentation& segmentation) {
    std::map<RoomId, std::uint32_t> place_of;
    std::vector<double> area_m2;
    for (const Room& room : segmentation.rooms) {
        place_of.emplace(room.id, static_cast<std::uint32_t>(area_m2.size()));
        area_m2.push_back(room.area_m2);
    }
    std::vector<WeightedEdge> edges;
    for (const Door& door : segmentation.doors) {
        edges.push_back(
            {place_of.at(door.a), place_of.at(door.b), std::min(door.width_m, kFullWidthM)});
    }
    return build_graph(edges, std::move(area_m2));
}

Graph joined_by_nearness(Graph graph, std::span<const Room> rooms) {
    std::vector<WeightedEdge> near = edges_to_nearest(graph, rooms);
    while (!near.empty()) {
        for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
            const auto neighbours = graph.neighbours(node);
            for (std::size_t k = 0; k < neighbours.size() && neighbours[k] <= node; ++k) {
                near.push_back({node, neighbours[k], graph.neighbour_weights(node)[k]});
            }
        }
        graph = build_graph(near, std::move(graph.area_m2));
        near = edges_to_nearest(graph, rooms);
    }
    return graph;
}

}  // namespace quadcut
