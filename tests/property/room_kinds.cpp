// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/building_case.hpp"
#include "bench/building_score.hpp"
#include "draw/floor_plan.hpp"
#include "formats/registry.hpp"
#include "io/map_server.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

// What rooms are called, and whether a picture says it of each of them.

namespace quadcut {
namespace {

/// A meeting room of 7 x 5 m with a table in its middle, and two doors to a corridor of 13 x 2 m.
GridMap meeting_room() {
    GridMap map;
    map.resolution_m = 0.05;
    map.states = Raster<CellState>({0, 0}, 270, 160, CellState::occupied);
    const auto paint = [&](double x0, double y0, double x1, double y1, CellState state) {
        for (auto y = static_cast<std::int32_t>(y0 * 20); y < static_cast<std::int32_t>(y1 * 20);
             ++y) {
            for (auto x = static_cast<std::int32_t>(x0 * 20);
                 x < static_cast<std::int32_t>(x1 * 20); ++x) {
                map.states.at({x, y}) = state;
            }
        }
    };
    paint(0.2, 0.2, 13.2, 2.2, CellState::free);
    paint(0.2, 2.4, 7.2, 7.4, CellState::free);
    paint(1.2, 2.2, 2.1, 2.4, CellState::free);
    paint(5.7, 2.2, 6.6, 2.4, CellState::free);
    paint(1.5, 4.0, 5.9, 5.8, CellState::occupied);
    paint(1.6, 4.1, 5.8, 5.7, CellState::unknown);
    return map;
}

void expect_meeting_room(const Segmentation& found) {
    ASSERT_EQ(found.rooms.size(), 2U);
    EXPECT_EQ(found.rooms[0].kind, RoomKind::room);
    EXPECT_EQ(found.rooms[1].kind, RoomKind::corridor);
}

TEST(RoomKinds, AMeetingRoomWithATableIsNoCorridor) {
    const GridMap map = meeting_room();
    const Segmentation found = segment(map, {});
    expect_meeting_room(found);
    const draw::FloorPlan plan = draw::lay_out_floor_plan(map, found, std::vector<io::Rgb>(2));
    EXPECT_EQ(plan.furniture.size(), 2U) << "the table: its edge, around its middle";
    EXPECT_EQ(plan.furniture_insides.size(), 1U);
}

TEST(RoomKinds, OfTheMeetingRoomOfTheField) {
    const auto path =
        std::filesystem::path(QUADCUT_SHARED_DIR) / "data" / "field" / "meeting_room_kind.yaml";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    expect_meeting_room(segment(io::read_map(path).map, {}));
}

TEST(RoomKinds, SlowMostAreRightOnSimulatedBuildings) {
    std::size_t num_right = 0;
    std::size_t num_all = 0;
    for (std::size_t i = 0; i < kNumCombinations; ++i) {
        const MappedBuilding mapped = map_building(building_case(i));
        const KindCounts counts =
            count_kinds(mapped, segment(mapped.map, {}, {}, mapped.trajectory));
        for (std::size_t truth = 0; truth < counts.size(); ++truth) {
            for (std::size_t found = 0; found < counts.size(); ++found) {
                num_all += counts[truth][found];
                if (truth == found) num_right += counts[truth][found];
            }
        }
    }
    EXPECT_GT(num_all, 200U);
    EXPECT_GE(static_cast<double>(num_right), 0.97 * static_cast<double>(num_all));
}

/// Each room has its name on the plan, or its number and a line of the legend.
void expect_words_for_all(const GridMap& map, const Segmentation& found) {
    const draw::FloorPlan plan =
        draw::lay_out_floor_plan(map, found, std::vector<io::Rgb>(found.rooms.size()));
    std::set<std::uint32_t> rooms;
    for (const draw::RoomLabel& label : plan.labels) {
        rooms.insert(label.room);
        const Room& room = found.rooms.at(label.room - 1);
        if (label.name.text == room.name) continue;
        EXPECT_EQ(label.name.text, std::to_string(index(room.id)));
        EXPECT_TRUE(std::any_of(plan.legend.begin(), plan.legend.end(),
                                [&](const auto& line) {
                                    return line.text.find(room.name + ", ") != std::string::npos;
                                }))
            << room.name << " is not in the legend";
    }
    EXPECT_EQ(rooms.size(), found.rooms.size());
    EXPECT_EQ(plan.labels.size(), found.rooms.size());
}

TEST(RoomLabels, EachRoomHasItsNameOrItsNumber) {
    for (const std::size_t i : {1U, 3U}) {
        const MappedBuilding mapped = map_building(building_case(i));
        expect_words_for_all(mapped.map, segment(mapped.map, {}, {}, mapped.trajectory));
    }
}

}  // namespace
}  // namespace quadcut
