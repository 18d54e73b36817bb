// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/covisibility.hpp"

#include <algorithm>
#include <vector>

#include "quadcut/base/ids.hpp"

namespace quadcut {
namespace {

std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax({a, b});
}

template <typename Counts, typename Key>
std::size_t count_of(const Counts& counts, const Key& key) {
    const auto found = counts.find(key);
    return found == counts.end() ? 0 : found->second;
}

}  // namespace

std::size_t Covisibility::num_seeing(std::uint32_t room) const {
    return count_of(scans_of_room, room);
}

std::size_t Covisibility::num_seeing_both(std::uint32_t a, std::uint32_t b) const {
    return count_of(scans_of_pair, pair_of(a, b));
}

std::size_t Covisibility::num_seeing_either(std::uint32_t a, std::uint32_t b) const {
    return num_seeing(a) + num_seeing(b) - num_seeing_both(a, b);
}

void count_scan(Covisibility& counts, std::span<const std::uint32_t> rooms) {
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        ++counts.scans_of_room[rooms[i]];
        for (std::size_t j = i + 1; j < rooms.size(); ++j) {
            ++counts.scans_of_pair[{rooms[i], rooms[j]}];
        }
    }
}

void join_rooms(Covisibility& counts, std::uint32_t ended, std::uint32_t now) {
    counts.scans_of_room[now] = counts.num_seeing_either(ended, now);
    std::vector<std::pair<std::uint32_t, std::size_t>> others;
    for (const auto& [pair, scans] : counts.scans_of_pair) {
        if (pair.first != ended && pair.second != ended) continue;
        const std::uint32_t other = pair.first == ended ? pair.second : pair.first;
        if (other != now) others.emplace_back(other, scans);
    }
    forget_room(counts, ended);
    for (const auto& [other, scans] : others) {
        std::size_t& both = counts.scans_of_pair[pair_of(other, now)];
        both = std::min({both + scans, counts.num_seeing(other), counts.num_seeing(now)});
    }
}

void forget_room(Covisibility& counts, std::uint32_t ended) {
    counts.scans_of_room.erase(ended);
    std::erase_if(counts.scans_of_pair, [ended](const auto& entry) {
        return entry.first.first == ended || entry.first.second == ended;
    });
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
    for (const auto& [pair, both] : counts.scans_of_pair) {
        const auto a = place_of.find(pair.first);
        const auto b = place_of.find(pair.second);
        if (a == place_of.end() || b == place_of.end()) continue;
        const std::size_t either = counts.num_seeing_either(pair.first, pair.second);
        edges.push_back(
            {a->second, b->second, static_cast<double>(both) / static_cast<double>(either)});
    }
    return build_graph(edges, std::move(areas_m2));
}

}  // namespace quadcut
