// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/track.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

using test::as_drawing;
using test::drawn_labels;
using Rows = std::vector<std::string>;
using Words = std::vector<std::string>;

/// A result as segment() leaves it: 'a' is room 1, ...; a cell is 1 m long.
Segmentation drawn_rooms(const Rows& rows) {
    const Raster<std::uint32_t> drawn = drawn_labels(rows);
    Segmentation result;
    result.labels = Raster<std::uint16_t>(drawn.box());
    const std::uint32_t count = *std::max_element(drawn.values.begin(), drawn.values.end());
    for (std::uint32_t id = 1; id <= count; ++id) {
        const auto num_cells = std::count(drawn.values.begin(), drawn.values.end(), id);
        result.rooms.push_back({RoomId{id},
                                "room " + std::to_string(id),
                                RoomKind::room,
                                static_cast<double>(num_cells),
                                {},
                                {}});
    }
    std::transform(drawn.values.begin(), drawn.values.end(), result.labels.values.begin(),
                   [](std::uint32_t label) { return static_cast<std::uint16_t>(label); });
    result.next_id = count + 1;
    return result;
}

EarlierRooms earlier_of(const Segmentation& result) {
    return {result.labels, 1.0, result.rooms, result.next_id};
}

EarlierRooms earlier_rooms(const Rows& rows) { return earlier_of(drawn_rooms(rows)); }

/// The rooms by their ids, as drawn_rooms() takes them.
Rows drawing_by_id(const Segmentation& result) {
    Raster<std::uint32_t> ids(result.labels.box());
    for (std::size_t i = 0; i < ids.values.size(); ++i) {
        const std::uint16_t label = result.labels.values[i];
        if (label == 0) continue;
        ids.values[i] = static_cast<std::uint32_t>(result.rooms.at(label - 1U).id);
    }
    return as_drawing(ids);
}

/// "kept 1", "split 3 from 1", ...
Words events_of(const Tracked& tracked) {
    const Words names{"kept", "born", "grown", "split", "merged", "retired"};
    Words words;
    for (const RoomEvent& event : tracked.events) {
        std::string text = names.at(static_cast<std::size_t>(event.change)) + " " +
                           std::to_string(index(event.room));
        if (event.other != RoomId{}) text += " - " + std::to_string(index(event.other));
        words.push_back(text);
    }
    return words;
}

TEST(Track, TheSameRoomsKeepIdsInWhateverOrderTheyCome) {
    const Tracked tracked = track(drawn_rooms({"bbb.cc", "bbb.cc", "..a..."}),
                                  earlier_rooms({"aaa.bb", "aaa.bb", "..c..."}));
    EXPECT_EQ(drawing_by_id(tracked.segmentation), (Rows{"aaa.bb", "aaa.bb", "..c..."}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 3", "kept 1", "kept 2"}));
    EXPECT_EQ(tracked.segmentation.next_id, 4U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(index(tracked.segmentation.rooms[i].id), i + 1) << "in the order of ids";
    }
}

TEST(Track, RoomsThatGrowOrShrinkAreKept) {
    const Tracked tracked =
        track(drawn_rooms({"aaaaaaaa", "b......."}), earlier_rooms({"aa......", "bbbbbb.."}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 1", "kept 2"}));
}

TEST(Track, ANewRoomIsBornWithTheNextId) {
    EarlierRooms earlier = earlier_rooms({"aaa...."});
    earlier.next_id = 5;
    const Tracked tracked = track(drawn_rooms({"aaa.bbb"}), earlier);
    EXPECT_EQ(events_of(tracked), (Words{"kept 1", "born 5"}));
    EXPECT_EQ(tracked.segmentation.rooms[1].name, "room 5");
    EXPECT_EQ(tracked.segmentation.next_id, 6U);
}

TEST(Track, TheLargestPartOfASplitRoomStaysTheRoom) {
    const Tracked tracked = track(drawn_rooms({"aaa.bbbbb.cc"}), earlier_rooms({"aaaaaaaaaaaa"}));
    EXPECT_EQ(events_of(tracked), (Words{"split 2 - 1", "kept 1", "split 3 - 1"}));
    EXPECT_EQ(drawing_by_id(tracked.segmentation), (Rows{"bbb.aaaaa.cc"}));
}

TEST(Track, OfEqualPartsTheFirstStaysTheRoom) {
    const Tracked tracked = track(drawn_rooms({"aaa.bbb"}), earlier_rooms({"aaaaaaa"}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 1", "split 2 - 1"}));
}

TEST(Track, MergedRoomsAreTheLargest) {
    const Tracked tracked = track(drawn_rooms({"aaaaaaaaa"}), earlier_rooms({"aa.bbbb.c"}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 2", "merged 1 - 2", "merged 3 - 2"}));
    EXPECT_EQ(tracked.events[1].name, "room 1");
    EXPECT_EQ(tracked.segmentation.next_id, 4U);
}

TEST(Track, ARoomWithoutCellsIsGoneAndItsIdIsNotGivenAgain) {
    const Tracked first = track(drawn_rooms({"aaa...."}), earlier_rooms({"aaa.bbb"}));
    EXPECT_EQ(events_of(first), (Words{"kept 1", "retired 2"}));
    const Tracked second = track(drawn_rooms({"aaa.bbb"}), earlier_of(first.segmentation));
    EXPECT_EQ(events_of(second), (Words{"kept 1", "born 3"}));
}

TEST(Track, ARoomOfWhichLittleIsLeftInAnotherIsGone) {
    // Two of five cells: neither the same nor merged.
    const Tracked tracked = track(drawn_rooms({"aaaaaaa..."}), earlier_rooms({"aaaaa.bbbb"}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 1", "retired 2"}));
}

TEST(Track, ARoomOfWhichLittleWasInAnotherIsBorn) {
    const Tracked tracked = track(drawn_rooms({"aaaaabbbbb"}), earlier_rooms({"aaaaaaa..."}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 1", "born 2"}));
}

TEST(Track, HalfIsEnough) {
    // The new b has two of its cells from a, the earlier b two of its in a.
    const Tracked less = track(drawn_rooms({"bbbbbaaaaaa..."}), earlier_rooms({"...aaaaaabbbbb"}));
    EXPECT_EQ(events_of(less), (Words{"kept 1", "born 3", "retired 2"}));
    const Tracked half = track(drawn_rooms({"bbbbaaaaaa.."}), earlier_rooms({"..aaaaaabbbb"}));
    EXPECT_EQ(events_of(half), (Words{"kept 1", "split 3 - 1", "merged 2 - 1"}));
}

TEST(Track, WhatLiesBeyondTheNewCellsCounts) {
    // One cell is left of a room of 8 m²: that is not the room.
    EarlierRooms earlier = earlier_rooms({"a......"});
    earlier.rooms[0].area_m2 = 8.0;
    EXPECT_EQ(events_of(track(drawn_rooms({"aaaaaaa"}), earlier)), (Words{"born 2", "retired 1"}));
}

TEST(Track, AMovedWallTakesNoIdsAlong) {
    // Seven cells of a now belong to b, more than those that a keeps.
    const Tracked tracked =
        track(drawn_rooms({"aaabbbbbbbbbbbbbbbbb"}), earlier_rooms({"aaaaaaaaaabbbbbbbbbb"}));
    EXPECT_EQ(events_of(tracked), (Words{"kept 1", "kept 2"}));
}

TEST(Track, ALargestPartIsNotGivenAwayForALargerSum) {
    // The new b shares 4 cells with the earlier a and 3 with b, the new a 2 with the earlier a.
    // In sum, 3 and 2 are more than 4.
    const Tracked tracked = track(drawn_rooms({"aabbbbbbb"}), earlier_rooms({"aaaaaabbb"}));
    EXPECT_EQ(events_of(tracked), (Words{"split 3 - 1", "kept 1", "merged 2 - 1"}));
}

TEST(Track, OwnNamesStayAndOthersFollowTheKind) {
    EarlierRooms earlier = earlier_rooms({"aa.bb.cc"});
    earlier.rooms[0].name = "Kitchen";
    earlier.rooms[1].name = "room 9";
    Segmentation now = drawn_rooms({"aa.bb.cc"});
    for (Room& room : now.rooms) room.kind = RoomKind::corridor;
    const Tracked tracked = track(now, earlier);
    EXPECT_EQ(tracked.segmentation.rooms[0].name, "Kitchen");
    EXPECT_EQ(tracked.segmentation.rooms[1].name, "room 9") << "not the name of room 2";
    EXPECT_EQ(tracked.segmentation.rooms[2].name, "corridor 3");
    EXPECT_EQ(tracked.segmentation.rooms[0].kind, RoomKind::corridor);
    EXPECT_EQ(tracked.events[0].name, "Kitchen");
}

TEST(Track, DoorsGoAlong) {
    Segmentation now = drawn_rooms({"aaa.bbb"});
    now.doors.push_back({RoomId{1}, RoomId{2}, {}, {}, 0.9, 1.0});
    EarlierRooms earlier = earlier_rooms({"bbb.aaa"});
    earlier.rooms[0].id = RoomId{40};
    earlier.next_id = 41;
    const Tracked tracked = track(now, earlier);
    EXPECT_EQ(index(tracked.segmentation.doors[0].a), 2U);
    EXPECT_EQ(index(tracked.segmentation.doors[0].b), 40U);
}

TEST(Track, OfNothingIsNothing) {
    EXPECT_EQ(events_of(track(drawn_rooms({"aa.b"}), earlier_rooms({"...."}))),
              (Words{"born 1", "born 2"}));
    EXPECT_EQ(events_of(track(drawn_rooms({"...."}), earlier_rooms({"aa.b"}))),
              (Words{"retired 1", "retired 2"}));
    EXPECT_TRUE(track({}, {}).events.empty());
}

TEST(Track, ThereAreNoIdsBeyondALabel) {
    EarlierRooms earlier = earlier_rooms({"a..."});
    earlier.next_id = kMaxRoomId;
    EXPECT_EQ(index(track(drawn_rooms({"a.b."}), earlier).segmentation.rooms[1].id), kMaxRoomId);
    EXPECT_THROW((void)track(drawn_rooms({"a.bc"}), earlier), InputError);
}

TEST(Track, RefusesLabelsOfOtherCells) {
    EXPECT_THROW((void)track(drawn_rooms({"aa"}), earlier_rooms({"aaa"})), std::logic_error);
}

}  // namespace
}  // namespace quadcut
