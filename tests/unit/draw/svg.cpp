// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/svg.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "draw/render.hpp"
#include "io/image.hpp"
#include "io/room_colors.hpp"
#include "tests/unit/io/floor_drawing.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::draw {
namespace {

io::test::DrawnFloor two_rooms() {
    io::test::DrawnFloor floor = io::test::drawn_floor(
        {"###########", "#aaaa#bbbb#", "#aaaaabbbb#", "#a#aa#bbbb#", "#aaaa#bbbb#", "###########"},
        10);
    floor.segmentation.doors.push_back({RoomId{1}, RoomId{2}, {3.0, 1.5}, {3.0, 2.0}, 0.5, 1.0});
    floor.segmentation.rooms[0].name = "Tom & \"Jerry\" <1>";
    return floor;
}

FloorPlan plan_of(const io::test::DrawnFloor& floor) {
    const auto pairs = io::find_near_rooms(floor.map, floor.segmentation);
    return lay_out_floor_plan(floor.map, floor.segmentation,
                              io::room_colors(floor.segmentation, pairs));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

TEST(FloorPlan, IsAWholeNumberOfPixelsACell) {
    const FloorPlan plan = plan_of(two_rooms());
    EXPECT_EQ(plan.pixels_per_half_cell, 10.5);  // 110 cells, 2310 pixels.
    EXPECT_GT(plan.page_width, 2310);
    EXPECT_LT(plan.page_width, 2400);
    EXPECT_EQ(plan.rooms.size(), 2U);
    EXPECT_EQ(plan.labels.size(), 2U);
    EXPECT_EQ(plan.scale_bar.text, "1 m");
    EXPECT_NEAR(plan.scale_bar.length, 21.0 * 20, 1e-9);
}

TEST(FloorPlan, ReachesUnderFurniture) {
    const FloorPlan plan = plan_of(two_rooms());
    EXPECT_EQ(plan.rooms[0].rings.size(), 1U);
    EXPECT_EQ(plan.furniture.size(), 1U);
    EXPECT_EQ(plan.walls.size(), 2U);  // Around the house, and around its rooms.
}

TEST(FloorPlan, PutsDoorsOnThePageWhateverTheFrame) {
    io::test::DrawnFloor floor = two_rooms();
    const FloorPlan straight = plan_of(floor);
    floor.map.map_from_image = {7.0, -3.0, 1.1};
    Segmentation& turned = floor.segmentation;
    for (Point* point : {&turned.doors[0].jamb_1, &turned.doors[0].jamb_2}) {
        *point = transform(floor.map.map_from_image, *point);
    }
    for (Room& room : turned.rooms) {
        room.centroid = transform(floor.map.map_from_image, room.centroid);
        room.label_point = transform(floor.map.map_from_image, room.label_point);
    }
    const FloorPlan same = plan_of(floor);
    EXPECT_NEAR(straight.doors[0].from.x, same.doors[0].from.x, 1e-6);
    EXPECT_NEAR(straight.doors[0].to.y, same.doors[0].to.y, 1e-6);
    EXPECT_NEAR(straight.labels[1].name.anchor.x, same.labels[1].name.anchor.x, 1e-6);
    EXPECT_NEAR(straight.doors[0].from.x, straight.drawing_origin.x + 60 * 21, 1e-6);
    EXPECT_NEAR(straight.doors[0].from.y, straight.drawing_origin.y + 30 * 21, 1e-6);
}

TEST(FloorPlan, OfALargeMapIsSmallerThanIt) {
    io::test::DrawnFloor floor = io::test::drawn_floor({std::string(9000, 'a')});
    const FloorPlan plan = plan_of(floor);
    EXPECT_NEAR(2.0 * plan.pixels_per_half_cell * 9000, 8000, 1.0);
    ASSERT_EQ(plan.legend.size(), 1U) << "there is no space for a name in one row of cells";
    EXPECT_LE(plan.page_width, 8192 + 300);
    floor = io::test::drawn_floor({std::string(3000, 'a')});
    EXPECT_EQ(plan_of(floor).pixels_per_half_cell, 0.5);
}

TEST(Svg, HasAPathATooltipAndALabelForEachRoom) {
    const std::string svg = render_svg(plan_of(two_rooms()));
    EXPECT_EQ(svg.find("<svg xmlns"), 0U);
    EXPECT_EQ(count(svg, "<path id=\"room-"), 2U);
    EXPECT_EQ(count(svg, "<title>Tom &amp; &quot;Jerry&quot; &lt;1&gt;\n4 m\u00B2, room</title>"),
              1U);
    EXPECT_EQ(count(svg, ">Room 2</text>"), 1U);
    EXPECT_EQ(count(svg, "<line id=\"door-1\""), 1U);
    EXPECT_EQ(count(svg, "<g"), count(svg, "</g>"));
    EXPECT_LT(svg.size(), 6500U);
}

TEST(FloorPlan, LabelsStandBesideFurniture) {
    io::test::DrawnFloor floor = io::test::drawn_floor(
        {"##########", "#aaaaaaaa#", "#aaaaaaaa#", "#aaaaaaaa#", "##########"}, 20);
    const FloorPlan empty = plan_of(floor);
    const auto label_row = [](const FloorPlan& plan) {
        return (plan.labels.at(0).name.anchor.y - plan.drawing_origin.y) /
               (40.0 * plan.pixels_per_half_cell);
    };
    EXPECT_NEAR(label_row(empty), 2.5, 0.2);
    // A table in the middle.
    for (std::int32_t x = 60; x < 140; ++x) {
        for (std::int32_t y = 40; y < 52; ++y) floor.map.states.at({x, y}) = CellState::occupied;
    }
    EXPECT_LT(label_row(plan_of(floor)), 2.2);
    EXPECT_EQ(plan_of(floor).labels[0].name.size, empty.labels[0].name.size);
}

/// A closet of 2 x 2 cells beside a hall; named so that there is no space for the name.
io::test::DrawnFloor closet_and_hall() {
    io::test::DrawnFloor floor =
        io::test::drawn_floor({"##########", "#bbbbbbbb#", "#bbbbbbbb#", "#bbbbbbbb#", "#bbbbbbbb#",
                               "####.#####", "   #a#    ", "   ###    "},
                              14);
    floor.segmentation.rooms[0].name = "A closet for brooms and other things that nobody wants";
    return floor;
}

TEST(FloorPlan, ARoomThatIsTooSmallForItsNameHasItsNumberAndALegend) {
    const FloorPlan plan = plan_of(closet_and_hall());
    ASSERT_EQ(plan.labels.size(), 2U);
    const auto label = std::find_if(plan.labels.begin(), plan.labels.end(),
                                    [](const RoomLabel& other) { return other.room == 1; });
    EXPECT_EQ(label->name.text, "1");
    EXPECT_FALSE(label->leader);
    ASSERT_FALSE(plan.legend.empty());
    EXPECT_EQ(plan.legend[0].text,
              "1: A closet for brooms and other things that nobody wants, 0.5 m\u00B2");
    EXPECT_EQ(plan.legend[0].ink, plan.rooms[0].color);
    EXPECT_GT(plan.legend[0].left.x, plan.drawing_origin.x + 140 * 2.0 * plan.pixels_per_half_cell);
    EXPECT_LT(plan.legend[0].left.x, plan.page_width);
    EXPECT_TRUE(plan_of(two_rooms()).legend[0].text == "furniture") << "no room is in its legend";
}

TEST(FloorPlan, ARoomTooSmallForItsNumberHasItBeside) {
    // Splinters of one cell's width among 600 columns.
    io::test::DrawnFloor floor = io::test::drawn_floor(
        {std::string(1500, ' '), std::string(1500, 'a'), std::string(1500, ' ')}, 1);
    for (std::int32_t y = 0; y < 2; ++y) {
        for (std::int32_t x = 0; x < 1500; ++x) {
            if (y == 1 && x == 700) floor.segmentation.labels.at({x, y}) = 1;
        }
    }
    const FloorPlan plan = plan_of(floor);
    ASSERT_EQ(plan.labels.size(), 1U);
    ASSERT_TRUE(plan.labels[0].leader);
    EXPECT_EQ(plan.labels[0].name.text, "1");
    const std::string svg = render_svg(plan);
    EXPECT_EQ(count(svg, "<g id=\"leaders\""), 1U);
    EXPECT_EQ(count(svg, "<circle"), 1U);
    EXPECT_EQ(count(svg, ">Room 1, "), 1U) << "in the legend";
    const FloorPlan half = placed(plan, 0.5, {10.0, 0.0});
    EXPECT_EQ(half.labels[0].leader->from.x, plan.labels[0].leader->from.x / 2.0 + 10.0);
    EXPECT_EQ(half.legend[0].left.x, plan.legend[0].left.x / 2.0 + 10.0);
}

TEST(FloorPlan, SaysWhatFurnitureAndDoorsAreWhereThereAreAny) {
    const FloorPlan plan = plan_of(two_rooms());
    ASSERT_EQ(plan.legend.size(), 2U);
    EXPECT_EQ(plan.legend[0].text, "furniture");
    EXPECT_EQ(plan.legend[0].ink, kFurnitureInsideInk);
    EXPECT_EQ(plan.legend[1].text, "door");
    EXPECT_EQ(plan.legend[1].ink, kDoorInk);
    EXPECT_TRUE(plan_of(io::test::drawn_floor({"aaa", "aaa"}, 40)).legend.empty());
    FloorPlan bare = plan;
    bare.remove_text();
    EXPECT_TRUE(bare.legend.empty());
    EXPECT_TRUE(bare.labels.empty());
    EXPECT_EQ(bare.scale_bar.length, 0.0);
}

TEST(FloorPlan, TheTextOfASlantedCorridorRunsAlongIt) {
    // 1.2 m wide, 14 m long, up by 27 degrees.
    io::test::DrawnFloor floor = io::test::drawn_floor({std::string(300, ' ')}, 1);
    floor.map.states = Raster<CellState>({0, 0}, 300, 180);
    floor.segmentation.labels = Raster<std::uint16_t>({0, 0}, 300, 180);
    for (std::int32_t x = 10; x < 290; ++x) {
        for (std::int32_t y = x / 2; y < x / 2 + 26; ++y) {
            floor.map.states.at({x, y}) = CellState::free;
            floor.segmentation.labels.at({x, y}) = 1;
        }
    }
    Room corridor;
    corridor.id = RoomId{1};
    corridor.name = "corridor to the laboratories 1";
    corridor.centroid = corridor.label_point = {7.5, 4.4};
    floor.segmentation.rooms = {corridor};
    const FloorPlan plan = plan_of(floor);
    ASSERT_EQ(plan.labels.size(), 1U);
    EXPECT_EQ(plan.labels[0].name.text, corridor.name);
    EXPECT_EQ(static_cast<int>(plan.labels[0].direction), 30);
    EXPECT_GE(count(render_svg(plan), "transform=\"rotate(-30 "), 1U);
}

TEST(FloorPlan, CanBePlacedOnAnotherPage) {
    const FloorPlan plan = plan_of(two_rooms());
    EXPECT_EQ(plan.frame, (Box{{0, 0}, {109, 59}}));
    const FloorPlan half = placed(plan, 0.5, {100.0, 7.0});
    const auto expect_placed = [](const Point& at, const Point& from) {
        EXPECT_NEAR(at.x, from.x / 2.0 + 100.0, 1e-9);
        EXPECT_NEAR(at.y, from.y / 2.0 + 7.0, 1e-9);
    };
    expect_placed(half.to_page({40, 30}), plan.to_page({40, 30}));
    expect_placed(half.doors[0].from, plan.doors[0].from);
    expect_placed(half.doors[0].to, plan.doors[0].to);
    expect_placed(half.labels[0].name.anchor, plan.labels[0].name.anchor);
    expect_placed(half.labels[0].area.value().anchor, plan.labels[0].area.value().anchor);
    expect_placed(half.scale_bar.origin, plan.scale_bar.origin);
    EXPECT_EQ(half.labels[0].name.size, plan.labels[0].name.size / 2.0);
    EXPECT_EQ(half.scale_bar.length, plan.scale_bar.length / 2.0);
    EXPECT_EQ(half.door_width, plan.door_width / 2.0);
}

TEST(Svg, WritesRingsAsShortSteps) {
    const std::string svg = render_svg(plan_of(io::test::drawn_floor({"aab", "aab"})));
    EXPECT_NE(svg.find("d=\"M4 4v-4h-4v4z\""), std::string::npos) << svg;
}

TEST(Svg, LosesWhatXmlCannotSay) {
    io::test::DrawnFloor floor = two_rooms();
    floor.segmentation.rooms[0].name = std::string("a\x01\x1F\xFF") + "z";
    EXPECT_NE(render_svg(plan_of(floor)).find(">a\uFFFDz<"), std::string::npos);
}

TEST(Picture, ShowsRoomsWallsAndPaper) {
    const io::test::ScratchFolder folder;
    const FloorPlan plan = plan_of(two_rooms());
    const io::Image image = io::read_image(folder.write("x.png", render_png(plan)));
    EXPECT_EQ(image.header, (io::ImageHeader{plan.page_width, plan.page_height, 3, 255}));
    const auto at = [&](double x, double y) {  // In characters of the drawing, from the top left.
        const auto px = static_cast<std::size_t>(plan.drawing_origin.x + x * 210);
        const auto py = static_cast<std::size_t>(plan.drawing_origin.y + y * 210);
        const std::size_t i = 3 * (py * static_cast<std::size_t>(plan.page_width) + px);
        return io::Rgb{static_cast<std::uint8_t>(image.samples[i]),
                       static_cast<std::uint8_t>(image.samples[i + 1]),
                       static_cast<std::uint8_t>(image.samples[i + 2])};
    };
    EXPECT_EQ(at(0.5, 0.5), kWallInk);
    EXPECT_EQ(at(1.2, 1.2), plan.rooms[0].color);
    EXPECT_EQ(at(9.8, 4.8), plan.rooms[1].color);
    EXPECT_EQ(at(2.5, 3.5), kFurnitureInk);
    EXPECT_EQ(at(6.0, 2.5), kDoorInk);
    EXPECT_EQ(at(5.5, 6.15), kPaper);
}

}  // namespace
}  // namespace quadcut::draw
