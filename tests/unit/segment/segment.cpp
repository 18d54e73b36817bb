// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/segment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

/// Six rooms along a corridor, with a few legs of furniture; resolution 0.05 m. Not symmetric.
GridMap office() {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 380, 290, CellState::unknown);
    const auto paint = [&](std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                           CellState state) {
        for (std::int32_t y = y0; y < y1; ++y) {
            for (std::int32_t x = x0; x < x1; ++x) map.states.at({x, y}) = state;
        }
    };
    paint(10, 10, 370, 280, CellState::occupied);
    paint(14, 124, 366, 164, CellState::free);
    const std::int32_t walls[] = {14, 110, 250, 366};
    for (int room = 0; room < 3; ++room) {
        const std::int32_t x0 = walls[room] + (room == 0 ? 0 : 4);
        const std::int32_t x1 = walls[room + 1] - (room == 2 ? 0 : 4);
        paint(x0, 14, x1, 120, CellState::free);
        paint(x0, 168, x1, 276, CellState::free);
        paint(x0 + 20, 120, x0 + 38, 124, CellState::free);
        paint(x1 - 45, 164, x1 - 27, 168, CellState::free);
    }
    for (std::int32_t x = 130; x < 240; x += 17) {
        paint(x, 60, x + 2, 62, CellState::occupied);
        paint(x, 80, x + 2, 82, CellState::occupied);
    }
    return map;
}

std::map<std::uint16_t, std::size_t> cells_by_label(const Segmentation& rooms) {
    std::map<std::uint16_t, std::size_t> cells;
    for (const std::uint16_t label : rooms.labels.values) ++cells[label];
    cells.erase(0);
    return cells;
}

std::size_t num_parts(const Raster<std::uint16_t>& labels, std::uint16_t label) {
    GridMap map;
    map.resolution_m = 1.0;
    map.states = Raster<CellState>({0, 0}, labels.width, labels.height);
    std::size_t parts = 0;
    std::vector<bool> seen(labels.values.size(), false);
    for (std::size_t seed = 0; seed < labels.values.size(); ++seed) {
        if (labels.values[seed] != label || seen[seed]) continue;
        ++parts;
        std::vector<std::size_t> stack{seed};
        seen[seed] = true;
        while (!stack.empty()) {
            const Cell cell = labels.cell(stack.back());
            stack.pop_back();
            for (const Cell next : {Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y},
                                    Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}}) {
                if (!labels.contains(next)) continue;
                const std::size_t offset = labels.offset(next);
                if (labels.values[offset] != label || seen[offset]) continue;
                seen[offset] = true;
                stack.push_back(offset);
            }
        }
    }
    return parts;
}

void expect_sound(const GridMap& map, const Segmentation& result) {
    ASSERT_EQ(result.labels.values.size(), map.states.values.size());
    const auto cells = cells_by_label(result);
    ASSERT_EQ(cells.size(), result.rooms.size());
    for (std::size_t i = 0; i < result.rooms.size(); ++i) {
        const Room& room = result.rooms[i];
        EXPECT_EQ(index(room.id), i + 1);
        EXPECT_NEAR(room.area_m2,
                    static_cast<double>(cells.at(static_cast<std::uint16_t>(i + 1))) *
                        map.resolution_m * map.resolution_m,
                    1e-6);
        EXPECT_EQ(num_parts(result.labels, static_cast<std::uint16_t>(i + 1)), 1U);
    }
    for (const Door& door : result.doors) {
        EXPECT_LT(index(door.a), index(door.b));
        EXPECT_LE(index(door.b), result.rooms.size());
        EXPECT_GT(door.width_m, 0.0);
    }
}

SegmentOptions preset(Preset which) {
    SegmentOptions options;
    options.preset = which;
    return options;
}

TEST(Segment, RoomsOfAnOffice) {
    const GridMap map = office();
    const Segmentation result = segment(map);
    expect_sound(map, result);
    EXPECT_EQ(result.rooms.size(), 7U);
    EXPECT_EQ(result.doors.size(), 6U);
    for (const Door& door : result.doors) EXPECT_NEAR(door.width_m, 0.9, 0.06);
    // Every free cell is in a room.
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        if (map.states.values[i] == CellState::free) {
            EXPECT_NE(result.labels.values[i], 0);
        }
    }
    const auto num_corridors =
        std::count_if(result.rooms.begin(), result.rooms.end(),
                      [](const Room& room) { return room.kind == RoomKind::corridor; });
    EXPECT_EQ(num_corridors, 1);
    EXPECT_GE(result.report.num_leaves, 7U);
    EXPECT_GE(result.report.num_edges, 6U);
    EXPECT_FALSE(result.report.eigen.empty());
    SegmentOptions options;
    options.rooms.pieces = PieceSource::basins;
    EXPECT_TRUE(segment(map, options).report.eigen.empty()) << "basins need no eigenvectors";
}

TEST(Segment, PaperMakesAsManySubmapsAsAsked) {
    const GridMap map = office();
    for (const std::size_t count : {2U, 5U, 7U}) {
        SegmentOptions options = preset(Preset::paper);
        options.paper.num_submaps = count;
        const Segmentation result = segment(map, options);
        expect_sound(map, result);
        EXPECT_EQ(result.rooms.size(), count);
    }
}

TEST(Segment, PaperChoosesTheNumber) {
    const GridMap map = office();
    for (const FirstCut by : {FirstCut::halves, FirstCut::eigengap, FirstCut::silhouette}) {
        SegmentOptions options = preset(Preset::paper);
        options.paper.first_cut = by;
        const Segmentation result = segment(map, options);
        expect_sound(map, result);
        EXPECT_GE(result.rooms.size(), 3U);
        EXPECT_LE(result.rooms.size(), 20U);
    }
}

TEST(Segment, PaperDoesNotDependOnWhereTheImageBegins) {
    const GridMap map = office();
    GridMap padded = map;
    const Cell by{37, 21};
    padded.states = Raster<CellState>({0, 0}, map.states.width + by.x, map.states.height + by.y);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        padded.states.at({cell.x + by.x, cell.y + by.y}) = map.states.values[i];
    }
    padded.map_from_image.x -= by.x * map.resolution_m;
    padded.map_from_image.y -= by.y * map.resolution_m;
    const Segmentation before = segment(map, preset(Preset::paper));
    const Segmentation after = segment(padded, preset(Preset::paper));
    EXPECT_EQ(after.rooms.size(), before.rooms.size());
    for (std::size_t i = 0; i < before.labels.values.size(); ++i) {
        const Cell cell = before.labels.cell(i);
        ASSERT_EQ(after.labels.at({cell.x + by.x, cell.y + by.y}), before.labels.values[i]);
    }
}

TEST(Segment, RoomsOffTheWayAreDroppedWhenAsked) {
    const GridMap map = office();
    const std::vector<Point> way{{3.0, 7.2}, {9.0, 7.2}, {9.0, 3.0}};
    SegmentOptions options;
    const std::size_t all = segment(map, options, {}, way).rooms.size();
    EXPECT_EQ(all, segment(map).rooms.size()) << "the preset rooms keeps them";
    options.uncrossed = Uncrossed::dropped;
    const Segmentation crossed = segment(map, options, {}, way);
    EXPECT_LT(crossed.rooms.size(), all);
    std::set<std::uint16_t> labels;
    for (const Cell cell : visited_cells(map, way)) labels.insert(crossed.labels.at(cell));
    labels.erase(0);
    EXPECT_EQ(labels.size(), crossed.rooms.size());
    EXPECT_EQ(segment(map, options).rooms.size(), all) << "no way is known";
    options.preset = Preset::paper;
    options.uncrossed = Uncrossed::kept;
    EXPECT_EQ(segment(map, options, {}, way).rooms.size(), segment(map, options).rooms.size());
}

TEST(Segment, PaperDropsSpecks) {
    // Two buildings that share nothing, and a speck.
    GridMap map = office();
    for (std::int32_t y = 0; y < 290; ++y) map.states.at({180, y}) = CellState::occupied;
    map.states.at({2, 2}) = CellState::free;
    SegmentOptions options = preset(Preset::paper);
    options.paper.num_submaps = 6;
    EXPECT_EQ(segment(map, options).labels.at({2, 2}), 0);
}

TEST(Segment, PaperDropsSubmapsThatTheTrajectoryDoesNotCross) {
    const GridMap map = office();
    SegmentOptions options = preset(Preset::paper);
    options.paper.num_submaps = 7;
    const std::vector<Point> trajectory{{3.0, 7.2}, {9.0, 7.2}, {9.0, 3.0}};
    const Segmentation all = segment(map, options);
    const Segmentation crossed = segment(map, options, {}, trajectory);
    EXPECT_LT(crossed.rooms.size(), all.rooms.size());
    for (const Cell cell : visited_cells(map, trajectory)) {
        if (all.labels.at(cell) != 0) {
            EXPECT_NE(crossed.labels.at(cell), 0);
        }
    }
}

/// Sixteen offices, enough for every parallel loop to have several chunks.
GridMap many_offices() {
    const GridMap one = office();
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 4 * one.states.width, 4 * one.states.height);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        map.states.values[i] =
            one.states.at({cell.x % one.states.width, cell.y % one.states.height});
    }
    return map;
}

SegmentOptions with_pieces(PieceSource pieces) {
    SegmentOptions options;
    options.rooms.pieces = pieces;
    return options;
}

TEST(Segment, SpectralPiecesMakeTheRoomsOfTheOffice) {
    const Segmentation result = segment(office(), with_pieces(PieceSource::spectral));
    const Segmentation basins = segment(office(), with_pieces(PieceSource::basins));
    EXPECT_EQ(result.labels.values, basins.labels.values);
    EXPECT_TRUE(basins.report.eigen.empty());
    ASSERT_FALSE(result.report.eigen.empty());
    EXPECT_NEAR(result.report.eigen.front().eigenvalues.front(), 0.0, 1e-9);
}

class ManyRooms : public testing::TestWithParam<PieceSource> {};

TEST_P(ManyRooms, AreTheSameOnAnyNumberOfThreads) {
    const GridMap map = many_offices();
    SegmentOptions options = with_pieces(GetParam());
    options.with_hierarchy = true;
    const Segmentation one = segment(map, options, RunOptions{1});
    EXPECT_EQ(one.rooms.size(), 16U * 7U);
    const Segmentation many = segment(map, options, RunOptions{4});
    EXPECT_EQ(many.labels.values, one.labels.values);
    EXPECT_EQ(many.hierarchy.finest.values, one.hierarchy.finest.values);
    ASSERT_EQ(many.doors.size(), one.doors.size());
    for (std::size_t i = 0; i < one.doors.size(); ++i) {
        EXPECT_EQ(many.doors[i].confidence, one.doors[i].confidence);
    }
}

INSTANTIATE_TEST_SUITE_P(Pieces, ManyRooms,
                         testing::Values(PieceSource::basins, PieceSource::spectral));

TEST(Segment, AnOutlinedTableInAHallIsNoRoomAtTheGranularityOfTheHall) {
    // 20 x 14 m with a table of 12 m^2, drawn as an outline, in the middle.
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 420, 300, CellState::occupied);
    for (std::int32_t y = 10; y < 290; ++y) {
        for (std::int32_t x = 10; x < 410; ++x) map.states.at({x, y}) = CellState::free;
    }
    for (std::int32_t x = 170; x < 250; ++x) {
        for (const std::int32_t y : {120, 180}) map.states.at({x, y}) = CellState::occupied;
    }
    for (std::int32_t y = 120; y <= 180; ++y) {
        for (const std::int32_t x : {170, 250}) map.states.at({x, y}) = CellState::occupied;
    }
    SegmentOptions options;
    options.with_hierarchy = true;
    const Segmentation result = segment(map, options);
    EXPECT_EQ(result.rooms.size(), 1U);
    const std::uint16_t inside = result.hierarchy.finest.at({210, 150});
    const std::uint16_t around = result.hierarchy.finest.at({50, 150});
    ASSERT_NE(inside, 0);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        ASSERT_EQ(result.hierarchy.finest.values[i] == 0, result.labels.values[i] == 0);
    }
    const HierarchyLevel& coarsest = result.hierarchy.levels.front();
    EXPECT_EQ(coarsest.region_of_finest[inside - 1U], coarsest.region_of_finest[around - 1U]);
    EXPECT_EQ(coarsest.num_regions, 1U);
}

TEST(Segment, ThreadsDoNotChangeAnything) {
    const GridMap map = office();
    for (const Preset which : {Preset::rooms, Preset::paper}) {
        const SegmentOptions options = preset(which);
        const Segmentation one = segment(map, options, RunOptions{1});
        for (const std::size_t num_threads : {2U, 3U, 8U}) {
            const Segmentation many = segment(map, options, RunOptions{num_threads});
            EXPECT_EQ(many.labels.values, one.labels.values);
            ASSERT_EQ(many.doors.size(), one.doors.size());
            for (std::size_t i = 0; i < one.doors.size(); ++i) {
                EXPECT_EQ(many.doors[i].width_m, one.doors[i].width_m);
            }
        }
    }
}

/// The map turned by a quarter, counter-clockwise, and mirrored at its vertical axis.
GridMap turned(const GridMap& map) {
    GridMap out = map;
    out.states = Raster<CellState>({0, 0}, map.states.height, map.states.width);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        out.states.at({map.states.height - 1 - cell.y, cell.x}) = map.states.values[i];
    }
    return out;
}

GridMap mirrored(const GridMap& map) {
    GridMap out = map;
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        out.states.at({map.states.width - 1 - cell.x, cell.y}) = map.states.values[i];
    }
    return out;
}

std::vector<double> sorted_areas(const Segmentation& result) {
    std::vector<double> areas;
    for (const Room& room : result.rooms) areas.push_back(room.area_m2);
    std::sort(areas.begin(), areas.end());
    return areas;
}

TEST(Segment, TurningAndMirroringDoNotMatter) {
    const GridMap map = office();
    for (const PieceSource pieces : {PieceSource::basins, PieceSource::spectral}) {
        const SegmentOptions options = with_pieces(pieces);
        const std::vector<double> areas = sorted_areas(segment(map, options));
        for (const GridMap& other : {turned(map), turned(turned(map)), mirrored(map)}) {
            const std::vector<double> other_areas = sorted_areas(segment(other, options));
            ASSERT_EQ(other_areas.size(), areas.size());
            for (std::size_t i = 0; i < areas.size(); ++i) {
                EXPECT_DOUBLE_EQ(other_areas[i], areas[i]) << "the same rooms to the cell";
            }
        }
    }
}

TEST(Segment, PaddingDoesNotMatter) {
    const GridMap map = office();
    GridMap padded = map;
    padded.states = Raster<CellState>({0, 0}, 437, 331, CellState::unknown);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        padded.states.at({cell.x + 37, cell.y + 21}) = map.states.values[i];
    }
    for (const PieceSource pieces : {PieceSource::basins, PieceSource::spectral}) {
        const SegmentOptions options = with_pieces(pieces);
        EXPECT_EQ(sorted_areas(segment(padded, options)), sorted_areas(segment(map, options)));
    }
}

TEST(Segment, TheHierarchyIsNestedAndChangesNoRoom) {
    const GridMap map = office();
    SegmentOptions options;
    const Segmentation plain = segment(map, options);
    EXPECT_TRUE(plain.hierarchy.levels.empty());
    options.with_hierarchy = true;
    const Segmentation result = segment(map, options);
    EXPECT_EQ(result.labels.values, plain.labels.values);
    const Hierarchy& hierarchy = result.hierarchy;
    ASSERT_GE(hierarchy.levels.size(), 2U);
    EXPECT_LT(hierarchy.levels.front().granularity, hierarchy.levels.back().granularity);
    EXPECT_DOUBLE_EQ(hierarchy.levels.back().granularity, 1.0);
    ASSERT_EQ(hierarchy.finest.values.size(), map.states.values.size());
    std::map<std::uint16_t, std::uint16_t> room_of_finest;
    for (std::size_t i = 0; i < hierarchy.finest.values.size(); ++i) {
        const std::uint16_t region = hierarchy.finest.values[i];
        ASSERT_EQ(region == 0, result.labels.values[i] == 0);
        if (region == 0) continue;
        const auto found = room_of_finest.emplace(region, result.labels.values[i]).first;
        ASSERT_EQ(found->second, result.labels.values[i]) << "a room cuts a region";
    }
    for (std::size_t k = 1; k < hierarchy.levels.size(); ++k) {
        const HierarchyLevel& coarse = hierarchy.levels[k - 1];
        const HierarchyLevel& fine = hierarchy.levels[k];
        EXPECT_LT(coarse.num_regions, fine.num_regions);
        std::map<std::uint16_t, std::uint16_t> coarse_of_fine;
        for (std::size_t i = 0; i < fine.region_of_finest.size(); ++i) {
            const auto found =
                coarse_of_fine.emplace(fine.region_of_finest[i], coarse.region_of_finest[i]).first;
            EXPECT_EQ(found->second, coarse.region_of_finest[i]);
        }
    }
}

TEST(Segment, DoorsSayHowWideTheRoomsBesideThemAre) {
    for (const Door& door : segment(office()).doors) {
        EXPECT_GT(door.room_a_width_m, door.width_m);
        EXPECT_GT(door.room_b_width_m, door.width_m);
    }
}

TEST(Segment, AMapWithoutFreeSpaceHasNoRooms) {
    GridMap map;
    for (const Preset which : {Preset::rooms, Preset::paper}) {
        map.states = Raster<CellState>({0, 0}, 50, 40, CellState::occupied);
        EXPECT_TRUE(segment(map, preset(which)).rooms.empty());
        map.states = Raster<CellState>({0, 0}, 1, 1, CellState::unknown);
        EXPECT_TRUE(segment(map, preset(which)).rooms.empty());
    }
}

TEST(Segment, ARoomThatFillsTheImageIsOne) {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 100, 60, CellState::free);
    EXPECT_EQ(segment(map).rooms.size(), 1U);
}

TEST(Inside, TheGroundAroundTheBuildingIsLeftOutUnlessVisited) {
    GridMap map = test::drawn_map({"............",  //
                                   ".##########.",  //
                                   ".#........#.",  //
                                   ".#........#.",  //
                                   ".##########.",  //
                                   "............"},
                                  0.05, 20);
    const auto area = [&](std::span<const Point> trajectory) {
        const Raster<std::uint8_t> kept = inside(map, trajectory, 1.0);
        return std::count(kept.values.begin(), kept.values.end(), 1) / 400;
    };
    EXPECT_EQ(area({}), 16);
    const std::vector<Point> outside{{0.5, 0.5}};
    EXPECT_EQ(area(outside), 16 + 32);
    const std::vector<Point> indoors{{5.0, 2.5}};
    EXPECT_EQ(area(indoors), 16);
    const std::vector<Point> nonsense{{std::nan(""), 1.0}, {1e300, 0.0}};
    EXPECT_EQ(area(nonsense), 16);
}

TEST(Inside, ATightlyCroppedRoomStays) {
    const GridMap map = test::drawn_map({"....#...",  //
                                         "....#...",  //
                                         "........",  //
                                         "....#...",  //
                                         "#####..."},
                                        0.05, 20);
    const Raster<std::uint8_t> kept = inside(map, {}, 1.0);
    EXPECT_EQ(std::count(kept.values.begin(), kept.values.end(), 1) / 400, 32);
}

TEST(Inside, SpecksAreDropped) {
    const GridMap map = test::drawn_map(
        {"..........", "##########", "..........", "#######..#", "#.########"}, 0.05, 4);
    const Raster<std::uint8_t> kept = inside(map, {}, 0.045);
    EXPECT_EQ(kept.at({4, 0}), 0);
    EXPECT_EQ(kept.at({4, 8}), 1);
}

}  // namespace
}  // namespace quadcut
