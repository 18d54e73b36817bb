// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/covisibility.hpp"

#include <algorithm>
#include <vector>

namespace quadcut {
namespace {

std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

/// Less is seen together by no scan that counts.
constexpr double kLeastScans = 1e-12;

}  // namespace

void count_scan(Covisibility& counts, std::span<const SeenFloor> floors) {
    double all = 0.0;
    for (const SeenFloor& floor : floors) all += floor.num_cells;
    for (std::size_t i = 0; i < floors.size(); ++i) {
        for (std::size_t j = i; j < floors.size(); ++j) {
            counts.scans[pair_of(floors[i].room, floors[j].room)] +=
                floors[i].num_cells / all * (floors[j].num_cells / all);
        }
    }
}

void join_rooms(Covisibility& counts, std::uint32_t ended, std::uint32_t now) {
    std::vector<std::pair<std::uint32_t, double>> others;
    for (const auto& [pair, scans] : counts.scans) {
        if (pair.first == ended) others.emplace_back(pair.second, scans);
        if (pair.second == ended && pair.first != ended) others.emplace_back(pair.first, scans);
    }
    std::erase_if(counts.scans, [ended](const auto& entry) {
        return entry.first.first == ended || entry.first.second == ended;
    });
    for (const auto& [other, scans] : others) {
        // What one of them shared with the other, it now shares with itself: both ways round.
        const double times = other == now ? 2.0 : 1.0;
        counts.scans[pair_of(other == ended ? now : other, now)] += times * scans;
    }
}

Graph covisibility_graph(const Covisibility& counts, const Segmentation& rooms) {
    std::map<std::uint32_t, std::uint32_t> place_of;
    std::vector<double> areas_m2;
    for (const Room& room : rooms.rooms) {
        place_of.emplace(static_cast<std::uint32_t>(room.id),
                         static_cast<std::uint32_t>(areas_m2.size()));
        areas_m2.push_back(room.area_m2);
    }
    std::vector<WeightedEdge> edges;
    for (const auto& [pair, scans] : counts.scans) {
        const auto a = place_of.find(pair.first);
        const auto b = place_of.find(pair.second);
        if (a == place_of.end() || b == place_of.end() || scans < kLeastScans) continue;
        edges.push_back({a->second, b->second, scans});
    }
    return build_graph(edges, std::move(areas_m2));
}

}  // namespace quadcut
