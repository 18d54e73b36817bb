// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "io/image.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::draw {
namespace {

constexpr io::Rgb kWhite{255, 255, 255};
constexpr io::Rgb kBlack{0, 0, 0};

/// How much ink is on a black-on-white canvas, in pixels.
double ink_on(const Canvas& canvas) {
    double sum = 0.0;
    for (std::int32_t y = 0; y < canvas.height(); ++y) {
        for (std::int32_t x = 0; x < canvas.width(); ++x) {
            sum += (255.0 - canvas.at(x, y).red) / 255.0;
        }
    }
    return sum;
}

Shape polygon(const std::vector<Point>& points) {
    Shape shape;
    shape.add_polygon(points);
    return shape;
}

TEST(Canvas, FillsWholePixelsCrisply) {
    Canvas canvas(6, 4, kWhite);
    canvas.fill(polygon({{1, 1}, {4, 1}, {4, 3}, {1, 3}}), kBlack);
    for (std::int32_t y = 0; y < 4; ++y) {
        for (std::int32_t x = 0; x < 6; ++x) {
            const bool inside = x >= 1 && x < 4 && y >= 1 && y < 3;
            EXPECT_EQ(canvas.at(x, y), inside ? kBlack : kWhite) << x << ", " << y;
        }
    }
}

TEST(Canvas, SharesPixelsByArea) {
    Canvas canvas(3, 1, kWhite);
    canvas.fill(polygon({{0.5, 0}, {2.25, 0}, {2.25, 1}, {0.5, 1}}), kBlack);
    EXPECT_NEAR(canvas.at(0, 0).red, 128, 1);
    EXPECT_EQ(canvas.at(1, 0).red, 0);
    EXPECT_NEAR(canvas.at(2, 0).red, 191, 1);

    Canvas triangle(1, 1, kWhite);
    triangle.fill(polygon({{0, 0}, {1, 0}, {0, 1}}), kBlack);
    EXPECT_NEAR(triangle.at(0, 0).red, 128, 1);
}

TEST(Canvas, CoversTheAreaOfAPolygonWhicheverWayRound) {
    const std::vector<Point> points = {{3.2, 2.1}, {17.7, 5.4}, {14.3, 18.9}, {6.6, 11.2}};
    double twice_area = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& a = points[i];
        const Point& b = points[(i + 1) % points.size()];
        twice_area += a.x * b.y - b.x * a.y;
    }
    Canvas canvas(20, 20, kWhite);
    canvas.fill(polygon(points), kBlack);
    EXPECT_NEAR(ink_on(canvas), std::abs(twice_area) / 2.0, 0.5);
    Canvas reversed(20, 20, kWhite);
    reversed.fill(polygon({points.rbegin(), points.rend()}), kBlack);
    EXPECT_NEAR(ink_on(reversed), ink_on(canvas), 0.1);
}

TEST(Canvas, LeavesHolesOpen) {
    Shape shape = polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}});
    shape.add_polygon(std::vector<Point>{{2, 2}, {2, 4}, {4, 4}, {4, 2}});
    Canvas canvas(6, 6, kWhite);
    canvas.fill(shape, kBlack);
    EXPECT_EQ(canvas.at(1, 3), kBlack);
    EXPECT_EQ(canvas.at(3, 3), kWhite);
    EXPECT_DOUBLE_EQ(ink_on(canvas), 32.0);
}

TEST(Canvas, DrawsALineOfItsWidthWithRoundEnds) {
    Shape shape;
    shape.add_line(std::vector<Point>{{10, 10}, {30, 10}}, 6.0);
    Canvas canvas(40, 20, kWhite);
    canvas.fill(shape, kBlack);
    EXPECT_NEAR(ink_on(canvas), 20 * 6 + std::numbers::pi * 9, 4.0);
    EXPECT_EQ(canvas.at(20, 7), kBlack);
    EXPECT_EQ(canvas.at(20, 6), kWhite);
    // Lines that cross are no darker, and have no hole, where they do.
    shape.add_line(std::vector<Point>{{20, 18}, {20, 2}}, 6.0);
    canvas.fill(shape, kBlack);
    EXPECT_EQ(canvas.at(20, 10), kBlack);
}

TEST(Canvas, CutsOffWhatIsOutside) {
    Canvas canvas(8, 8, kWhite);
    canvas.fill(polygon({{-100, -100}, {4, -100}, {4, 100}, {-100, 100}}), kBlack);
    canvas.fill(polygon({{-50, 20}, {50, 20}, {0, 60}}), kBlack);
    canvas.fill(polygon({{9, 2}, {900, 2}, {900, 5}, {9, 5}}), kBlack);
    EXPECT_DOUBLE_EQ(ink_on(canvas), 32.0);
    canvas.fill(polygon({{-1, -1}, {9, -1}, {9, 9}, {-1, 9}}), kBlack);
    EXPECT_DOUBLE_EQ(ink_on(canvas), 64.0);
    canvas.fill(Shape(), kWhite);
}

TEST(Canvas, LaysThinInkOverWhatIsThere) {
    Canvas canvas(1, 1, kWhite);
    canvas.fill(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {55, 155, 255}, 0.5);
    EXPECT_EQ(canvas.at(0, 0), (io::Rgb{155, 205, 255}));
}

TEST(Canvas, IsWrittenAsRgb) {
    const io::test::ScratchFolder folder;
    Canvas canvas(2, 1, {1, 2, 3});
    canvas.fill(polygon({{1, 0}, {2, 0}, {2, 1}, {1, 1}}), {4, 5, 6});
    const io::Image image = io::read_image(folder.write("x.png", canvas.encode_png()));
    EXPECT_EQ(image.header, (io::ImageHeader{2, 1, 3, 255}));
    EXPECT_EQ(image.samples, (std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6}));
}

/// Shapes of all kinds across many bands, some of them beyond the page.
Canvas busy_canvas() {
    Canvas canvas(90, 300, kWhite);
    canvas.fill(polygon({{10, -20}, {80, 150}, {20, 320}, {40, 140}}), {200, 30, 60});
    Shape lines;
    for (int i = 0; i < 12; ++i) {
        const double y = 27.3 * i;
        lines.add_closed_line(std::vector<Point>{{-5, y}, {60.5, y + 70}, {120, y + 3}}, 3.7);
        lines.add_disc({45, y}, 6.0);
    }
    canvas.fill(lines, {20, 90, 200}, 0.6);
    return canvas;
}

TEST(Canvas, IsTheSameOnAnyNumberOfThreads) {
    const Canvas canvas = busy_canvas();
    EXPECT_EQ(canvas.encode_png(Executor{3}), canvas.encode_png());
}

TEST(Canvas, HasNoSeamsBetweenBands) {
    const io::test::ScratchFolder folder;
    const Canvas canvas = busy_canvas();
    const io::Image image = io::read_image(folder.write("x.png", canvas.encode_png()));
    ASSERT_EQ(image.header, (io::ImageHeader{90, 300, 3, 255}));
    std::size_t num_inked = 0;
    for (std::int32_t y = 0; y < 300; ++y) {
        for (std::int32_t x = 0; x < 90; ++x) {
            const auto samples = image.row(y).subspan(3 * static_cast<std::size_t>(x), 3);
            const io::Rgb alone = canvas.at(x, y);  // Painted as a band of this row only.
            EXPECT_EQ(samples[0], alone.red) << x << ", " << y;
            EXPECT_EQ(samples[1], alone.green) << x << ", " << y;
            EXPECT_EQ(samples[2], alone.blue) << x << ", " << y;
            if (alone != kWhite) ++num_inked;
        }
    }
    EXPECT_GT(num_inked, 10000U);
}

TEST(Canvas, InkShowsOnWhatIsNotOfItsColor) {
    Canvas canvas(20, 70, kBlack);
    const Shape square = polygon({{2, 2}, {18, 2}, {18, 68}, {2, 68}});
    canvas.fill(square, kBlack);
    EXPECT_EQ(canvas.at(10, 35), kBlack);
    canvas.fill(polygon({{5, 66}, {6, 66}, {6, 67}, {5, 67}}), kWhite);
    canvas.fill(square, kBlack, 0.5);
    EXPECT_NEAR(canvas.at(5, 66).red, 128, 1) << "the one pixel that is not black";
    EXPECT_EQ(canvas.at(10, 35), kBlack);
}

}  // namespace
}  // namespace quadcut::draw
