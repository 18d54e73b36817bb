// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "bench/data_map.hpp"
#include "quadcut/follow/track.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"

// What must hold of every map that is cut again with the rooms that it had.

namespace quadcut {
namespace {

GridMap building_map(std::size_t draw) {
    sim::BuildingOptions options;
    options.seed = 700 + draw;
    options.num_rooms = 12 + 5 * static_cast<int>(draw);
    return sim::generate_building(options).map;
}

Segmentation cut_again(const GridMap& map, const Raster<std::uint16_t>& earlier) {
    return segment(map, {}, {}, {}, earlier);
}

void expect_the_same_again(const GridMap& map, const std::string& name) {
    const Segmentation first = segment(map);
    const Segmentation again = cut_again(map, first.labels);
    std::size_t num_changed = 0;
    for (std::size_t i = 0; i < first.labels.values.size(); ++i) {
        if (again.labels.values[i] != first.labels.values[i]) ++num_changed;
    }
    EXPECT_EQ(num_changed, 0U) << name << ": " << again.rooms.size() << " rooms, not "
                               << first.rooms.size();
    EXPECT_TRUE(again.doors == first.doors) << name;
}

TEST(EarlierRoomsOfMaps, AreThereAgainOnTheSameMap) {
    for (std::size_t draw = 0; draw < 4; ++draw) {
        expect_the_same_again(building_map(draw), std::to_string(draw));
    }
}

TEST(EarlierRoomsOfMaps, AreThereAgainOnTheSameDataMapSlow) {
    const std::vector<DataMap> maps = read_data_maps();
    if (maps.empty()) GTEST_SKIP() << "the maps of the data are not there";
    for (const DataMap& data : maps) expect_the_same_again(data.map, data.name);
}

TEST(EarlierRoomsOfMaps, ALevelOfTheHierarchyHasTheRooms) {
    const GridMap map = building_map(1);
    SegmentOptions options;
    options.with_hierarchy = true;
    // A result of which every second border is gone: the rooms are other ones than without it.
    Raster<std::uint16_t> earlier = segment(map).labels;
    for (std::uint16_t& room : earlier.values) room = static_cast<std::uint16_t>((room + 1) / 2);
    const Segmentation rooms = segment(map, options, {}, {}, earlier);
    bool is_any = false;
    for (const HierarchyLevel& level : rooms.hierarchy.levels) {
        is_any = is_any || level.num_regions == rooms.rooms.size();
    }
    EXPECT_TRUE(is_any);
    EXPECT_LT(rooms.rooms.size(), segment(map).rooms.size());
}

TEST(EarlierRoomsOfMaps, OfAnotherFrameSayNothing) {
    const GridMap map = building_map(0);
    const Segmentation first = segment(map);
    Raster<std::uint16_t> shifted(first.labels.box());
    for (std::size_t i = 0; i < shifted.values.size(); ++i) {
        const Cell cell = shifted.cell(i);
        const Cell from{cell.x - map.states.width / 4, cell.y - map.states.height / 4};
        if (first.labels.contains(from)) shifted.values[i] = first.labels.at(from);
    }
    const Segmentation rooms = cut_again(map, shifted);
    EXPECT_TRUE(rooms.labels.values == first.labels.values);
    ASSERT_EQ(rooms.report.warnings.size(), 1U);
    EXPECT_NE(rooms.report.warnings[0].find("same map frame"), std::string::npos);
}

std::size_t num_changed(const Segmentation& then, const Segmentation& now) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < now.labels.values.size(); ++i) {
        const std::uint16_t a = then.labels.values[i];
        const std::uint16_t b = now.labels.values[i];
        if (a == 0 || b == 0) continue;
        if (then.rooms[a - std::size_t{1}].id != now.rooms[b - std::size_t{1}].id) ++count;
    }
    return count;
}

TEST(EarlierRoomsOfMaps, StayWhereTheEvidenceIsSomewhatWeaker) {
    std::size_t with = 0;
    std::size_t without = 0;
    for (std::size_t draw = 0; draw < 6; ++draw) {
        const GridMap map = building_map(draw);
        SegmentOptions finer;
        finer.rooms.granularity = 0.8;
        const Segmentation then = segment(map, finer);
        const auto tracked = [&](Segmentation rooms) {
            return track(std::move(rooms),
                         {then.labels, map.resolution_m, then.rooms, then.next_id})
                .segmentation;
        };
        with += num_changed(then, tracked(cut_again(map, then.labels)));
        without += num_changed(then, tracked(segment(map)));
    }
    EXPECT_LT(4 * with, without) << with << " " << without;
}

}  // namespace
}  // namespace quadcut
