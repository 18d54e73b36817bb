// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/faults.hpp"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "bench/gallery/fault_pane.hpp"
#include "bench/gallery/pair_picture.hpp"
#include "eval/labels.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::gallery {
namespace {

constexpr std::int32_t kScale = 20;

/// Each character is 20 x 20 cells of 5 cm.
Exhibit exhibit_of(const std::vector<std::string>& truth, const std::vector<std::string>& result,
                   bool has_void_rule = false) {
    const io::test::DrawnFloor true_floor = io::test::drawn_floor(truth, kScale);
    const io::test::DrawnFloor floor = io::test::drawn_floor(result, kScale);
    std::optional<io::FreeMask> mask;
    if (has_void_rule) {
        const std::size_t num_cells = floor.segmentation.labels.values.size();
        mask = io::FreeMask{floor.segmentation.labels.width, floor.segmentation.labels.height,
                            std::vector<std::uint8_t>(num_cells, 1)};
    }
    return make_exhibit("two", true_floor.map, as_label_image(true_floor.segmentation.labels),
                        floor.map, floor.segmentation, mask);
}

/// In the middle of a character of the drawing.
Verdict verdict_at(const Faults& faults, std::int32_t column, std::int32_t row_from_below) {
    return faults.verdicts.at({column * kScale + kScale / 2, row_from_below * kScale + kScale / 2});
}

TEST(GalleryFaults, ABorderTooManyAndOneTooFew) {
    // a and b are one room of the result, c is cut in two.
    const Faults faults = find_faults(
        exhibit_of({"########", "#aaabcc#", "########"}, {"########", "#aaaadc#", "########"}));
    EXPECT_EQ(faults.missed.size(), 20U);
    EXPECT_TRUE(std::all_of(faults.missed.begin(), faults.missed.end(), [](const CellSide& side) {
        return side.cell.x == 4 * kScale - 1 && !side.is_upper;
    }));
    EXPECT_EQ(faults.over_cut.size(), 20U);
    EXPECT_TRUE(std::all_of(faults.over_cut.begin(), faults.over_cut.end(),
                            [](const CellSide& side) { return side.cell.x == 6 * kScale - 1; }));
    EXPECT_EQ(faults.agreed.size(), 20U);
    EXPECT_EQ(faults.num_over_cuts, 1U);
    EXPECT_EQ(faults.num_missed_cuts, 1U);
    EXPECT_EQ(verdict_at(faults, 2, 1), Verdict::right);
    EXPECT_EQ(verdict_at(faults, 4, 1), Verdict::wrong);
    EXPECT_EQ(verdict_at(faults, 0, 1), Verdict::none) << "a wall";
}

TEST(GalleryFaults, ABorderALittleBesideIsTheSame) {
    Exhibit exhibit = exhibit_of({"#####", "#aab#", "#####"}, {"#####", "#aab#", "#####"});
    // Half a metre to the right, then a metre.
    const auto move = [&](std::int32_t cells) {
        Raster<std::uint16_t>& labels = exhibit.result.rooms.labels;
        for (std::int32_t y = kScale; y < 2 * kScale; ++y) {
            for (std::int32_t x = kScale; x < 4 * kScale - 1; ++x) {
                labels.at({x, y}) = x < 3 * kScale + cells ? 1 : 2;
            }
        }
        return find_faults(exhibit);
    };
    EXPECT_EQ(move(10).agreed.size(), 20U);
    EXPECT_EQ(move(10).missed.size(), 0U);
    EXPECT_EQ(move(15).over_cut.size(), 20U);
    EXPECT_EQ(move(15).missed.size(), 20U);
}

TEST(GalleryFaults, HandMadeRoomsWithAGapBetweenThemTouch) {
    Exhibit exhibit = exhibit_of({"#####", "#aab#", "#####"}, {"#####", "#aaa#", "#####"});
    for (std::int32_t y = kScale; y < 2 * kScale; ++y) {
        for (std::int32_t x = 3 * kScale - 4; x < 3 * kScale + 4; ++x) {
            exhibit.truth.rooms.labels.at({x, y}) = 0;
        }
    }
    EXPECT_EQ(find_faults(exhibit).missed.size(), 20U);
}

TEST(GalleryFaults, WhatIsMissingAndWhatCountsNowhere) {
    const std::vector<std::string> truth{"########", "#aa.b..#", "########"};
    const std::vector<std::string> result{"########", "#aa..cc#", "########"};
    const Exhibit exhibit = exhibit_of(truth, result, true);
    const Faults faults = find_faults(exhibit);
    EXPECT_EQ(exhibit.comparison.score.rooms, 1U);
    EXPECT_EQ(verdict_at(faults, 1, 1), Verdict::right);
    EXPECT_EQ(verdict_at(faults, 3, 1), Verdict::none);
    EXPECT_EQ(verdict_at(faults, 4, 1), Verdict::unlabelled);
    EXPECT_EQ(verdict_at(faults, 5, 1), Verdict::left_out);
    EXPECT_EQ(exhibit_of(truth, result).comparison.score.rooms, 2U);
}

TEST(GalleryFaults, ThePaneSaysOnlyWhatItShows) {
    const auto texts = [](const Exhibit& exhibit) {
        std::vector<std::string> said;
        for (const FaultKey& key : FaultPane(exhibit).keys()) said.push_back(key.text);
        return said;
    };
    const std::vector<std::string> whole{"#####", "#aab#", "#####"};
    EXPECT_EQ(texts(exhibit_of(whole, whole)), (std::vector<std::string>{"right"}));
    EXPECT_EQ(FaultPane(exhibit_of(whole, whole)).cuts_text(), "");
    EXPECT_EQ(texts(exhibit_of(whole, {"#####", "#aaa#", "#####"})),
              (std::vector<std::string>{"missed: 1 (1 m)", "right", "in a wrong room"}));
}

TEST(GalleryFaults, ThePaneDrawsEachKindInItsInk) {
    const Exhibit exhibit =
        exhibit_of({"########", "#aaabcc#", "########"}, {"########", "#aaaadc#", "########"});
    const PairPicture picture(exhibit);
    const double scale = picture.pixels_per_cell(1000.0, 1000.0);
    draw::Canvas canvas(1000, 400, draw::kPaper);
    const FaultPane pane(exhibit);
    pane.draw(canvas, picture.frame(), {0.0, 0.0}, scale, draw::Typeface());
    const auto at = [&](double column) {
        const double x = (column * kScale - picture.frame().low.x) * scale;
        const double y = (picture.frame().high.y + 1 - 1.5 * kScale) * scale;
        return canvas.at(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
    };
    const std::vector<FaultKey> keys = pane.keys();
    ASSERT_EQ(keys.size(), 4U);
    EXPECT_EQ(at(6.0), keys[0].ink) << keys[0].text;
    EXPECT_EQ(at(4.0), keys[1].ink) << keys[1].text;
    EXPECT_EQ(at(2.0), keys[2].ink) << keys[2].text;
    EXPECT_EQ(at(4.5), keys[3].ink) << keys[3].text;
}

}  // namespace
}  // namespace quadcut::gallery
