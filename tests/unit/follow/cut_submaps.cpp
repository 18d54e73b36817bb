// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The paper's incremental segmentation, step by step.
#include "quadcut/follow/cut_submaps.hpp"

#include <gtest/gtest.h>

#include "quadcut/follow/cut_again.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {
namespace {

constexpr std::int32_t kRoom = 96;
constexpr std::int32_t kWall = 4;

/// The cells of room 1, 2, ... of a row of rooms of 4.8 x 4.8 m.
Box cells_of_room(std::int32_t number) {
    const std::int32_t x = kWall + (number - 1) * (kRoom + kWall);
    return {{x, kWall}, {x + kRoom - 1, kWall + kRoom - 1}};
}

Cell middle_of_room(std::int32_t number) {
    const Box box = cells_of_room(number);
    return {box.low.x + kRoom / 2, box.low.y + kRoom / 2};
}

/// A row of rooms with doors of 0.8 m between them, all seen. `fresh` is new, the others are
/// submaps already, by their number.
FollowedMap row_of_rooms(std::int32_t count, std::int32_t fresh) {
    FollowedMap followed(0.05);
    const Box all{{0, 0}, {count * (kRoom + kWall) + kWall - 1, kRoom + 2 * kWall - 1}};
    for_each_cell(all, [&](Cell cell) { followed.map.set_state(cell, CellState::occupied); });
    const auto clear = [&](Cell cell) { followed.map.set_state(cell, CellState::free); };
    for (std::int32_t number = 1; number <= count; ++number) {
        const Box box = cells_of_room(number);
        for_each_cell(box, clear);
        if (number == count) continue;
        for_each_cell({{box.high.x + 1, 48}, {box.high.x + kWall, 63}}, clear);
    }
    const MapUpdate change = followed.map.commit();
    for (std::int32_t number = 1; number <= count; ++number) {
        if (number == fresh) continue;
        const auto id = static_cast<std::uint32_t>(number);
        Box box = cells_of_room(number);
        // And the door to the next, unless that is new.
        if (number + 1 != fresh && number != count) box.high.x += kWall;
        for_each_cell(box, [&](Cell cell) {
            if (followed.map.state(cell) != CellState::free) return;
            followed.cells.set_room(cell, id);
            followed.cells.set_cut_free(cell, true);
            ++followed.rooms[id].num_cells;
        });
        followed.rooms[id].box = box;
    }
    followed.next_id = static_cast<std::uint32_t>(count + 1);
    Changes changes;
    note_written(followed, change.written, changes);
    return followed;
}

/// Nothing has changed since rooms were cut.
void note_cut(FollowedMap& followed) {
    for_each_cell(followed.written, [&](Cell cell) {
        followed.cells.set_cut_free(cell, followed.map.state(cell) == CellState::free);
    });
    followed.changed_tiles.clear();
    followed.num_changed = 0;
}

WindowCut cut(const FollowedMap& followed) {
    SegmentOptions options;
    options.preset = Preset::paper;
    Window window = window_of_seen(followed);
    // Submaps that nothing was seen of are looked at, too: they are to stay as they are.
    Box box = window.states.box();
    box.include(followed.written);
    return cut_submaps(followed, read_window(followed, box, box), options, Executor{1});
}

bool is_cut(const WindowCut& cut, std::int32_t room) {
    return cut.regions.at(middle_of_room(room)) != kNotCut;
}

TEST(CutSubmaps, StepTwoMakesSubmapsOfWhatIsNew) {
    const WindowCut alone = cut(row_of_rooms(3, 2));
    EXPECT_GE(alone.num_regions, 1U);
    EXPECT_NE(alone.regions.at(middle_of_room(2)), 0U);
    EXPECT_TRUE(is_cut(alone, 2));
}

TEST(CutSubmaps, StepFourTakesOldSubmapsThatWereSeenTogetherWithTheNew) {
    FollowedMap followed = row_of_rooms(3, 2);
    followed.seen = {1};
    const WindowCut taken = cut(followed);
    EXPECT_TRUE(is_cut(taken, 1));
    EXPECT_TRUE(is_cut(taken, 2));
    EXPECT_FALSE(is_cut(taken, 3)) << "it touches what is new, but was not seen with it";
}

TEST(CutSubmaps, StepThreeLeavesOldSubmapsThatNoEdgeJoinsWithTheNew) {
    FollowedMap followed = row_of_rooms(4, 2);
    followed.seen = {1, 4};
    const WindowCut taken = cut(followed);
    EXPECT_TRUE(is_cut(taken, 1));
    EXPECT_FALSE(is_cut(taken, 3));
    EXPECT_FALSE(is_cut(taken, 4)) << "seen through two doors";
}

TEST(CutSubmaps, StepFiveMakesTheAuxiliaryGraphOfTheTemporaryListAlone) {
    FollowedMap followed = row_of_rooms(3, 2);
    const std::size_t fresh = cut(followed).num_nodes;
    followed.seen = {1};
    const std::size_t with_one = cut(followed).num_nodes;
    followed.seen = {1, 3};
    const std::size_t with_both = cut(followed).num_nodes;
    // Rooms 1 and 3 alone are what they have more.
    FollowedMap only_one = row_of_rooms(1, 1);
    EXPECT_LT(fresh, with_one);
    EXPECT_LT(with_one, with_both);
    EXPECT_NEAR(static_cast<double>(with_one - fresh), static_cast<double>(cut(only_one).num_nodes),
                8.0);
}

TEST(CutSubmaps, StepSixFindsTheRooms) {
    FollowedMap followed = row_of_rooms(3, 2);
    followed.seen = {1, 3};
    const WindowCut taken = cut(followed);
    EXPECT_EQ(taken.num_regions, 3U);
    const auto region = [&](std::int32_t room) { return taken.regions.at(middle_of_room(room)); };
    EXPECT_NE(region(1), region(2));
    EXPECT_NE(region(2), region(3));
}

TEST(CutSubmaps, ASubmapThatLosesFloorIsTaken) {
    FollowedMap followed = row_of_rooms(3, 2);
    followed.seen = {3};
    // All is known; then a piece of room 3, far from the door, is a wall.
    note_cut(followed);
    for_each_cell(cells_of_room(2), [&](Cell cell) { followed.cells.set_room(cell, 2); });
    followed.rooms[2].box = cells_of_room(2);
    for_each_cell({{280, 40}, {295, 47}},
                  [&](Cell cell) { followed.map.set_state(cell, CellState::occupied); });
    Changes changes;
    note_written(followed, followed.map.commit().written, changes);
    EXPECT_TRUE(is_cut(cut(followed), 3));
    EXPECT_FALSE(is_cut(cut(followed), 1));
}

TEST(NoteSeen, TakesTheSubmapsOfAnObservationInThePresetPaperOnly) {
    FollowedMap followed = row_of_rooms(3, 2);
    const std::vector<Cell> tiles{tile_of(middle_of_room(1)), tile_of(middle_of_room(2))};
    note_seen(followed, Preset::rooms, tiles);
    EXPECT_TRUE(followed.seen.empty());
    note_seen(followed, Preset::paper, tiles);
    EXPECT_EQ(followed.seen, std::set<std::uint32_t>{1});
    EXPECT_TRUE(followed.seen_roomless.is_empty()) << "room 2 is new: it was never cut";
}

TEST(NoteSeen, KnowsFloorThatIsNoPartOfTheMap) {
    FollowedMap followed = row_of_rooms(3, 2);
    for_each_cell(cells_of_room(2), [&](Cell cell) { followed.cells.set_cut_free(cell, true); });
    note_seen(followed, Preset::paper, {tile_of(middle_of_room(2))});
    EXPECT_TRUE(followed.seen_roomless.contains(middle_of_room(2)));
    const Window window = window_of_seen(followed);
    EXPECT_TRUE(window.decided.contains(middle_of_room(2)));
}

TEST(DropUncrossed, RegionsOffTheWayAreNoneAndTheOthersAreNumberedAnew) {
    FollowedMap followed = row_of_rooms(3, 2);
    followed.seen = {1, 3};
    WindowCut taken = cut(followed);
    ASSERT_EQ(taken.num_regions, 3U);
    WindowCut as_it_was = taken;
    drop_uncrossed({}, taken);
    EXPECT_EQ(taken.regions.values, as_it_was.regions.values) << "no way is known";
    drop_uncrossed({middle_of_room(2), middle_of_room(3), {-500, 0}}, taken);
    EXPECT_EQ(taken.num_regions, 2U);
    EXPECT_EQ(taken.regions.at(middle_of_room(1)), 0U);
    const std::set<std::uint32_t> left{taken.regions.at(middle_of_room(2)),
                                       taken.regions.at(middle_of_room(3))};
    EXPECT_EQ(left, (std::set<std::uint32_t>{1, 2}));
}

TEST(NoteWay, EnteringWhatWasDroppedIsAReasonToCut) {
    FollowOptions options;
    options.segment.preset = Preset::paper;
    FollowedMap followed = row_of_rooms(3, 2);
    note_cut(followed);
    Changes changes;
    const auto go_to = [&](std::int32_t room) {
        const Cell cell = middle_of_room(room);
        return note_way(followed, {(cell.x + 0.5) * 0.05, (cell.y + 0.5) * 0.05}, options, changes);
    };
    EXPECT_FALSE(go_to(1));
    EXPECT_TRUE(go_to(2));
    EXPECT_FALSE(go_to(2)) << "it stands still";
    EXPECT_EQ(followed.way.size(), 2U);
    EXPECT_TRUE(
        followed.changed_tiles.count({tile_of(middle_of_room(2)).x, tile_of(middle_of_room(2)).y}));
    options.segment.uncrossed = Uncrossed::kept;
    EXPECT_FALSE(go_to(1) || go_to(2));
}

}  // namespace
}  // namespace quadcut
