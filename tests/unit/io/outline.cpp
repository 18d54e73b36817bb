// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/outline.hpp"

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::io {
namespace {

using test::drawn_values;

std::vector<std::vector<Cell>> exact_rings(const RegionOutline& outline) {
    std::vector<std::vector<Cell>> rings;
    for (const OutlineRing& ring : outline.rings) rings.push_back(corners_of(ring));
    return rings;
}

/// Twice the area, positive if counter-clockwise.
std::int64_t twice_area(const std::vector<Cell>& ring) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Cell a = ring[i];
        const Cell b = ring[(i + 1) % ring.size()];
        sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
    }
    return sum;
}

TEST(Outline, OfACellIsASquare) {
    const auto outlines = trace_outlines(drawn_values({"..", ".a"}));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].value, 1U);
    EXPECT_EQ(outlines[0].num_cells, 1U);
    EXPECT_EQ(exact_rings(outlines[0]),
              (std::vector<std::vector<Cell>>{{{2, 0}, {2, 1}, {1, 1}, {1, 0}}}));
}

TEST(Outline, IsInTheRastersCoordinates) {
    Raster<std::uint16_t> values({-7, 3}, 1, 1, 5);
    const auto outlines = trace_outlines(values);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(exact_rings(outlines[0]),
              (std::vector<std::vector<Cell>>{{{-6, 3}, {-6, 4}, {-7, 4}, {-7, 3}}}));
}

TEST(Outline, MergesStraightRunsAndTurnsAtCorners) {
    const auto outlines = trace_outlines(drawn_values({"aa.", "aaa"}));
    EXPECT_EQ(exact_rings(outlines[0]),
              (std::vector<std::vector<Cell>>{{{3, 0}, {3, 1}, {2, 1}, {2, 2}, {0, 2}, {0, 0}}}));
}

TEST(Outline, HolesRunClockwise) {
    const auto outlines = trace_outlines(drawn_values({"aaaa", "a.ba", "aaaa"}));
    ASSERT_EQ(outlines.size(), 2U);
    const auto rings = exact_rings(outlines[0]);
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_EQ(twice_area(rings[0]), 24);
    EXPECT_EQ(twice_area(rings[1]), -4);
}

TEST(Outline, HoleThatTouchesTheOutsideInACornerStaysAHole) {
    // The hole meets the outside in the lower left corner, between two cells of the region.
    const auto outlines = trace_outlines(drawn_values({"aaa", "a.a", ".aa"}));
    ASSERT_EQ(outlines.size(), 1U);
    const auto rings = exact_rings(outlines[0]);
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_EQ(twice_area(rings[0]) + twice_area(rings[1]), 14);
    EXPECT_EQ(rings[1].size(), 4U);
}

TEST(Outline, CellsThatMeetInACornerOnlyAreTwoRegions) {
    const auto outlines = trace_outlines(drawn_values({".a", "a."}));
    ASSERT_EQ(outlines.size(), 2U);
    EXPECT_EQ(outlines[0].rings.size(), 1U);
    EXPECT_EQ(outlines[1].rings.size(), 1U);
}

TEST(Outline, DiagonalValueIsJoinedAtCornersAndPartsWhatIsBeside) {
    const std::vector<std::string> drawing = {"bba", "bab", "abb"};
    const auto outlines = trace_outlines(drawn_values(drawing), 1);
    ASSERT_EQ(outlines.size(), 3U);
    EXPECT_EQ(outlines[0].value, 1U);
    EXPECT_EQ(outlines[0].num_cells, 3U);
    ASSERT_EQ(outlines[0].rings.size(), 1U);
    EXPECT_EQ(twice_area(corners_of(outlines[0].rings[0])), 6);
    EXPECT_EQ(outlines[1].num_cells, 3U);
    EXPECT_EQ(outlines[2].num_cells, 3U);
    for (const OutlinePoint& point : outlines[0].rings[0]) {
        const bool inner = point.x > 0 && point.x < 3 && point.y > 0 && point.y < 3;
        EXPECT_FALSE(inner && point.is_junction) << point.x << ", " << point.y;
    }
}

TEST(Outline, KeepsJunctionsOnStraightRuns) {
    const auto outlines = trace_outlines(drawn_values({"bc", "aa"}));
    const OutlineRing& ring = outlines[0].rings[0];
    EXPECT_EQ(ring.size(), 5U);
    EXPECT_EQ(corners_of(ring).size(), 4U);
    EXPECT_NE(std::find(ring.begin(), ring.end(), OutlinePoint{1, 1, true}), ring.end());
}

TEST(Outline, OfNothingIsEmpty) {
    EXPECT_TRUE(trace_outlines(Raster<std::uint16_t>({0, 0}, 3, 2)).empty());
    EXPECT_TRUE(trace_outlines(Raster<std::uint16_t>()).empty());
}

/// Paints a polygon with its holes by even-odd crossings of each cell's centre.
void paint(const std::vector<std::vector<Cell>>& rings, Raster<std::uint16_t>& cells) {
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
        const Cell cell = cells.cell(i);
        int num_crossings = 0;
        for (const auto& ring : rings) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Cell a = ring[k];
                const Cell b = ring[(k + 1) % ring.size()];
                const bool crosses = a.x == b.x && a.x > cell.x && std::min(a.y, b.y) <= cell.y &&
                                     cell.y < std::max(a.y, b.y);
                if (crosses) ++num_crossings;
            }
        }
        if (num_crossings % 2 != 0) ++cells.values[i];
    }
}

TEST(Outline, OfRandomRegionsIsExact) {
    Random random(3);
    for (int round = 0; round < 60; ++round) {
        Raster<std::uint16_t> values({0, 0}, 14, 11);
        for (std::uint16_t& value : values.values) {
            value = static_cast<std::uint16_t>(random.below(3));
        }
        Raster<std::uint16_t> covered({0, 0}, 14, 11);
        std::size_t num_cells = 0;
        for (const RegionOutline& outline : trace_outlines(values)) {
            const auto rings = exact_rings(outline);
            std::int64_t sum = 0;
            for (std::size_t i = 0; i < rings.size(); ++i) {
                EXPECT_EQ(twice_area(rings[i]) > 0, i == 0);
                sum += twice_area(rings[i]);
                // No ring passes a point twice.
                std::set<std::pair<int, int>> points;
                for (const Cell corner : rings[i]) {
                    EXPECT_TRUE(points.emplace(corner.x, corner.y).second);
                }
            }
            EXPECT_EQ(sum, 2 * static_cast<std::int64_t>(outline.num_cells));
            num_cells += outline.num_cells;
            paint(rings, covered);
        }
        std::size_t num_values = 0;
        for (std::size_t i = 0; i < values.values.size(); ++i) {
            if (values.values[i] != 0) ++num_values;
            EXPECT_EQ(covered.values[i], values.values[i] != 0 ? 1U : 0U);
        }
        EXPECT_EQ(num_cells, num_values);
    }
}

}  // namespace
}  // namespace quadcut::io
