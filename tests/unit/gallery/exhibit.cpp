// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/exhibit.hpp"

#include <gtest/gtest.h>

#include "bench/gallery/index_page.hpp"
#include "bench/gallery/pair_picture.hpp"
#include "eval/labels.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::gallery {
namespace {

const std::vector<std::string> kTruth = {"########", "#aa#bbb#", "#aaabbb#", "########"};
const std::vector<std::string> kResult = {"########", "#bb#ddd#", "#bbbddd#", "########"};

Exhibit exhibit_of(const std::vector<std::string>& truth, const std::vector<std::string>& result) {
    constexpr std::int32_t kScale = 20;
    const io::test::DrawnFloor true_floor = io::test::drawn_floor(truth, kScale);
    io::test::DrawnFloor floor = io::test::drawn_floor(result, kScale);
    if (floor.segmentation.rooms.size() == 4) {
        for (const std::uint32_t room : {2U, 1U}) {
            floor.segmentation.doors.push_back(
                {RoomId{room}, RoomId{4}, {4.0, 1.0}, {4.0, 2.0}, 1.0, 1.0});
        }
    }
    return make_exhibit("two", true_floor.map, as_label_image(true_floor.segmentation.labels),
                        floor.map, floor.segmentation);
}

TEST(GalleryExhibit, NumbersRoomsLikeTheRegionsThatAreCompared) {
    const Exhibit exhibit = exhibit_of(kTruth, kResult);
    EXPECT_EQ(exhibit.comparison.score.pq, 1.0);
    ASSERT_EQ(exhibit.result.rooms.rooms.size(), 2U);
    EXPECT_EQ(exhibit.result.rooms.labels.values, exhibit.truth.rooms.labels.values);
    // Room 1 has no cells, and its door is none.
    ASSERT_EQ(exhibit.result.rooms.doors.size(), 1U);
    EXPECT_EQ(exhibit.result.rooms.doors[0].a, RoomId{1});
    EXPECT_EQ(exhibit.result.rooms.doors[0].b, RoomId{2});
}

TEST(GalleryExhibit, ResamplesWhereverTheFrameIs) {
    const io::test::DrawnFloor floor = io::test::drawn_floor({"ab", "cd"}, 1, 1.0);
    GridMap frame;
    frame.resolution_m = 0.5;
    frame.map_from_image = {1.0, 1.0, 0.0};
    frame.states = Raster<CellState>({0, 0}, 3, 2);
    const Side side = resampled(frame, floor.map, floor.segmentation);
    EXPECT_EQ(side.rooms.labels.values, (Raster<std::uint16_t>::Values{2, 2, 0, 2, 2, 0}));
    EXPECT_EQ(side.map.states.at({1, 1}), CellState::free);
    EXPECT_EQ(side.map.states.at({2, 1}), CellState::unknown);
}

TEST(GalleryPicture, ShowsMatchesInOneColourAndMarksErrors) {
    const Exhibit exhibit = exhibit_of(kTruth, {"########", "#bb#ddd#", "#bbbddd#", "########"});
    const Exhibit merged = exhibit_of(kTruth, {"########", "#bb#bbb#", "#bbbbbb#", "########"});
    const auto color_at = [](const Exhibit& shown, double column, bool of_result) {
        const PairPicture picture(shown);
        const double scale = picture.pixels_per_cell(1000.0, 1000.0);
        draw::Canvas canvas(1000, 400, draw::kPaper);
        picture.draw(canvas, {0.0, 0.0}, scale, draw::Typeface());
        const double left = of_result ? picture.pane_width(scale) + PairPicture::kGap : 0.0;
        return canvas.at(static_cast<std::int32_t>(left + column * 20.0 * scale),
                         static_cast<std::int32_t>(2.85 * 20.0 * scale));
    };
    EXPECT_EQ(color_at(exhibit, 1.2, false), color_at(exhibit, 1.2, true));
    EXPECT_EQ(color_at(exhibit, 6.8, false), color_at(exhibit, 6.8, true));
    EXPECT_NE(color_at(exhibit, 1.2, true), color_at(exhibit, 6.8, true));
    // Of five sixths, the larger part is found; the smaller one is not.
    EXPECT_EQ(color_at(merged, 1.2, true), color_at(merged, 6.8, true));
    EXPECT_NE(color_at(merged, 1.2, false), color_at(merged, 1.2, true));
    EXPECT_EQ(color_at(merged, 6.8, false), color_at(merged, 6.8, true));
}

TEST(GalleryPage, PutsTheWorstFirst) {
    Entry good{"good", "good.png", "", 2, 1, exhibit_of(kTruth, kResult).comparison};
    Entry bad{"bad <&>", "bad.png", "", 1, 0, good.comparison};
    bad.comparison->score.pq = 0.5;
    const Entry unknown{"unknown", "unknown.png", "", 1, 0, std::nullopt};
    const std::string page = index_page({{"Maps", {unknown, good, bad}}, {"Nothing", {}}});
    EXPECT_LT(page.find("bad.png"), page.find("good.png"));
    EXPECT_LT(page.find("good.png"), page.find("unknown.png"));
    EXPECT_NE(page.find("bad &lt;&amp;&gt;"), std::string::npos);
    EXPECT_EQ(page.find("Nothing"), std::string::npos);
}

}  // namespace
}  // namespace quadcut::gallery
