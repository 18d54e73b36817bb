// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/voronoi.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/rooms/drawing.hpp"

namespace quadcut::reproduce {
namespace {

// A character is 4 x 4 cells of 5 cm: rooms of 3.2 x 2.4 m, a door of 0.8 m.
constexpr std::int32_t kScale = 4;
constexpr double kResolution = 0.05;

const std::vector<std::string> kTwoRooms{
    "###################################",  //
    "#................#................#",  //
    "#................#................#",  //
    "#................#................#",  //
    "#................#................#",  //
    "#.................................#",  //
    "#.................................#",  //
    "#.................................#",  //
    "#.................................#",  //
    "#................#................#",  //
    "#................#................#",  //
    "#................#................#",  //
    "#................#................#",  //
    "###################################",  //
};

VoronoiRegions regions_of(const std::vector<std::string>& rows) {
    return voronoi_regions(test::drawn_mask(rows, '.', kScale), kResolution);
}

Cell at(std::int32_t column, std::int32_t row_from_below) {
    return {column * kScale + 1, row_from_below * kScale + 1};
}

TEST(Voronoi, TwoRoomsAndADoorAreTwoRegions) {
    const VoronoiRegions result = regions_of(kTwoRooms);
    EXPECT_EQ(result.num_regions, 2U);
    EXPECT_GE(result.num_critical, 1U);
    const std::uint32_t left = result.regions.at(at(3, 6));
    const std::uint32_t right = result.regions.at(at(30, 6));
    EXPECT_NE(left, 0U);
    EXPECT_NE(right, 0U);
    EXPECT_NE(left, right);
    // The cut lies in the wall's opening.
    EXPECT_EQ(result.regions.at(at(15, 6)), left);
    EXPECT_EQ(result.regions.at(at(19, 6)), right);
}

TEST(Voronoi, OpenCellsAndNoOthersHaveARegion) {
    const Raster<std::uint8_t> open = test::drawn_mask(kTwoRooms, '.', kScale);
    const VoronoiRegions result = voronoi_regions(open, kResolution);
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        EXPECT_EQ(result.regions.values[i] != 0, open.values[i] != 0) << i;
        EXPECT_LE(result.regions.values[i], result.num_regions);
    }
}

TEST(Voronoi, OneRoomStaysOne) {
    std::vector<std::string> rows = kTwoRooms;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) rows[i][17] = '.';
    EXPECT_EQ(regions_of(rows).num_regions, 1U);
}

TEST(Voronoi, AClosetJoinsItsRoom) {
    // Less than 4 m2 behind the door.
    std::vector<std::string> rows = kTwoRooms;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
        for (std::size_t x = 23; x < 34; ++x) rows[i][x] = '#';
    }
    const VoronoiRegions result = regions_of(rows);
    EXPECT_EQ(result.num_regions, 1U);
    EXPECT_GE(result.num_critical, 1U);
}

TEST(Voronoi, NothingOpenIsNoRegion) {
    const VoronoiRegions result = voronoi_regions(Raster<std::uint8_t>({0, 0}, 9, 9), kResolution);
    EXPECT_EQ(result.num_regions, 0U);
    EXPECT_EQ(result.num_graph_cells, 0U);
}

}  // namespace
}  // namespace quadcut::reproduce
