// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/no_rooms_in_map.hpp"

#include <string>

#include <gtest/gtest.h>

#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut::io {
namespace {

/// A map of unknown cells, with free ones from (x0, y0) up to (x1, y1).
GridMap map_with_free(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
    GridMap map;
    map.resolution_m = 0.05;
    map.states = Raster<CellState>({0, 0}, 200, 100, CellState::unknown);
    for (std::int32_t y = y0; y < y1; ++y) {
        for (std::int32_t x = x0; x < x1; ++x) map.states.at({x, y}) = CellState::free;
    }
    return map;
}

/// Why there is none in a map without rooms.
std::string reason_of(const GridMap& map, const SegmentOptions& options = {}) {
    EXPECT_TRUE(segment(map, options).rooms.empty());
    return why_no_rooms(map, options);
}

void expect_words(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(NoRoomsInMap, BecauseNothingIsFree) {
    expect_words(reason_of(map_with_free(0, 0, 0, 0)), "no cell of the map is free");
}

TEST(NoRoomsInMap, BecauseAllIsTooSmall) {
    const std::string text = reason_of(map_with_free(50, 20, 78, 48));
    expect_words(text, "1.96 m²");
    expect_words(text, "rooms.min_component");
    SegmentOptions smaller;
    smaller.rooms.min_component_m2 = 1.9;
    EXPECT_EQ(segment(map_with_free(50, 20, 78, 48), smaller).rooms.size(), 1U);
}

TEST(NoRoomsInMap, BecauseAllIsTooNarrow) {
    SegmentOptions narrow;
    narrow.rooms.min_component_m2 = 1.0;
    expect_words(reason_of(map_with_free(20, 40, 180, 44), narrow), "rooms.min_passable");
}

TEST(NoRoomsInMap, BecauseTheRestIsGroundOutside) {
    GridMap map = map_with_free(0, 0, 200, 100);
    for (std::int32_t y = 20; y < 60; ++y) {
        for (std::int32_t x = 20; x < 180; ++x) {
            const bool is_slit = x > 22 && x < 177 && y >= 30 && y < 36;
            map.states.at({x, y}) = is_slit ? CellState::free : CellState::occupied;
        }
    }
    SegmentOptions narrow;
    narrow.rooms.min_component_m2 = 2.0;
    expect_words(reason_of(map, narrow), "ground outside");
}

TEST(NoRoomsInMap, OfThePaper) {
    SegmentOptions paper;
    paper.preset = Preset::paper;
    expect_words(reason_of(map_with_free(50, 20, 60, 30), paper), "paper.min_component");
}

}  // namespace
}  // namespace quadcut::io
