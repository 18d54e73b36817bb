// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/hierarchy.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr int kNumSteps = 10;

/// The level at which the regions are now; regions are numbered in the order of their first one.
HierarchyLevel level_of(const RegionGraph& regions, const std::vector<std::uint32_t>& finest,
                        double granularity, std::span<const Enclosure> enclosures) {
    const auto host_of = enclosing_regions(regions, enclosures);
    HierarchyLevel level;
    level.granularity = granularity;
    std::map<std::uint32_t, std::uint16_t> number;
    for (const std::uint32_t piece : finest) {
        const std::uint32_t region = regions.region_of(piece);
        const auto host = host_of.find(region);
        const auto next = static_cast<std::uint16_t>(number.size() + 1);
        level.region_of_finest.push_back(
            number.try_emplace(host == host_of.end() ? region : host->second, next).first->second);
    }
    level.num_regions = static_cast<std::uint32_t>(number.size());
    return level;
}

}  // namespace

void fuse_to_number(Fuser& fuser, const RegionGraph& regions, const Raster<std::uint32_t>& labels,
                    std::span<const Enclosure> enclosures, double min_log_odds, std::size_t least) {
    std::vector<bool> is_left(regions.num_pieces() + std::size_t{1}, false);
    for (const std::uint32_t region : labels.values) is_left[region] = true;
    std::vector<std::uint32_t> finest;
    for (std::uint32_t region = 1; region < is_left.size(); ++region) {
        if (is_left[region]) finest.push_back(region);
    }
    while (level_of(regions, finest, 0.0, enclosures).num_regions > least) {
        if (!fuser.fuse_next_below(min_log_odds)) return;
    }
}

Hierarchy build_hierarchy(const Raster<std::uint32_t>& labels, RegionGraph regions,
                          double max_width_m, std::span<const Enclosure> enclosures,
                          EarlierDecisions earlier) {
    std::vector<std::uint32_t> finest;
    std::vector<std::uint32_t> number(regions.num_pieces() + 1, 0);
    Hierarchy hierarchy;
    hierarchy.finest = Raster<std::uint16_t>(labels.origin, labels.width, labels.height);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const std::uint32_t region = labels.values[i];
        if (region == 0) continue;
        if (number[region] == 0) {
            finest.push_back(region);
            number[region] = static_cast<std::uint32_t>(finest.size());
        }
        hierarchy.finest.values[i] = static_cast<std::uint16_t>(number[region]);
    }
    if (finest.size() > kMaxRoomId) {
        throw InputError("the finest level of the hierarchy has " + std::to_string(finest.size()) +
                         " regions: expected at most 65535, the range of a label");
    }
    Fuser fuser(regions, max_width_m, {}, std::move(earlier));
    for (int step = kNumSteps; step >= 0; --step) {
        const double granularity = static_cast<double>(step) / kNumSteps;
        fuser.fuse_below(fuse_threshold(granularity));
        HierarchyLevel level = level_of(regions, finest, granularity, enclosures);
        const bool is_new =
            hierarchy.levels.empty() || level.num_regions < hierarchy.levels.back().num_regions;
        if (is_new) hierarchy.levels.push_back(std::move(level));
    }
    std::reverse(hierarchy.levels.begin(), hierarchy.levels.end());
    return hierarchy;
}

void keep_nested(Hierarchy& hierarchy, const Raster<std::uint32_t>& rooms) {
    if (hierarchy.levels.empty()) return;
    const std::size_t num_finest = hierarchy.levels.front().region_of_finest.size();
    std::vector<std::uint32_t> room_of(num_finest + 1, 0);
    std::map<std::pair<std::uint16_t, std::uint32_t>, std::uint16_t> split;
    for (std::size_t i = 0; i < rooms.values.size(); ++i) {
        std::uint16_t& region = hierarchy.finest.values[i];
        const std::uint32_t room = rooms.values[i];
        if (region == 0 || room == 0 || room_of[region] == room) continue;
        if (room_of[region] == 0) {
            room_of[region] = room;
            continue;
        }
        const auto next = static_cast<std::uint16_t>(num_finest + split.size() + 1);
        const auto [at, is_new] = split.try_emplace(std::pair{region, room}, next);
        for (HierarchyLevel& level : hierarchy.levels) {
            if (is_new) level.region_of_finest.push_back(level.region_of_finest[region - 1U]);
        }
        region = at->second;
    }
}

}  // namespace quadcut
