// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/label_image.hpp"

#include <gtest/gtest.h>

#include "io/image.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::ScratchFolder;

/// `counts[i]` pixels of `values[i]`, in one row.
std::vector<std::uint32_t> runs(const std::vector<std::uint32_t>& values,
                                const std::vector<std::size_t>& counts) {
    std::vector<std::uint32_t> pixels;
    for (std::size_t i = 0; i < values.size(); ++i)
        pixels.insert(pixels.end(), counts[i], values[i]);
    return pixels;
}

TEST(LabelImage, NumbersRegionsByValueWithoutGaps) {
    const auto pixels = runs({500, 0, 7, 500, 30}, {60, 40, 101, 60, 200});
    const LabelImage image = number_regions(static_cast<std::int32_t>(pixels.size()), 1, pixels);
    EXPECT_EQ(image.num_regions, 3U);
    EXPECT_EQ(image.values, runs({3, 0, 1, 3, 2}, {60, 40, 101, 60, 200}));
}

TEST(LabelImage, IgnoresRegionsOfAHundredPixels) {
    const auto pixels = runs({1, 2, 3}, {100, 101, 300});
    const LabelImage image = number_regions(501, 1, pixels);
    EXPECT_EQ(image.num_regions, 2U);
    EXPECT_EQ(image.values, runs({0, 1, 2}, {100, 101, 300}));
}

TEST(LabelImage, WithoutZeroHasARegionForEveryPixel) {
    const LabelImage image = number_regions(300, 1, runs({9, 4}, {150, 150}));
    EXPECT_EQ(image.num_regions, 2U);
    EXPECT_EQ(image.values, runs({2, 1}, {150, 150}));
}

TEST(LabelImage, ReadsGreyAndColours) {
    const ScratchFolder folder;
    Image grey{{300, 1, 1, 65535}, std::vector<std::uint16_t>(300, 0)};
    for (std::size_t x = 100; x < 300; ++x) grey.samples[x] = 40'000;
    write_png(folder.path() / "grey.png", grey);
    EXPECT_EQ(read_label_image(folder.path() / "grey.png").values, runs({0, 1}, {100, 200}));

    // The same red, told apart by blue; alpha says nothing.
    Image colour{{450, 1, 4, 255}, std::vector<std::uint16_t>(1800, 0)};
    for (std::size_t x = 150; x < 450; ++x) {
        colour.samples[4 * x] = 10;
        colour.samples[4 * x + 2] = x < 300 ? 1 : 0;
        colour.samples[4 * x + 3] = static_cast<std::uint16_t>(x % 256);
    }
    write_png(folder.path() / "colour.png", colour);
    EXPECT_EQ(read_label_image(folder.path() / "colour.png").values,
              runs({0, 2, 1}, {150, 150, 150}));
}

TEST(LabelImage, FreeIsBrighterThanUnknown) {
    const ScratchFolder folder;
    write_png(folder.path() / "map.png", Image{{4, 1, 1, 255}, {0, 205, 206, 254}});
    EXPECT_EQ(read_free_mask(folder.path() / "map.png").is_free,
              (std::vector<std::uint8_t>{0, 0, 1, 1}));
    write_png(folder.path() / "rgb.png", Image{{2, 1, 3, 255}, {255, 255, 0, 255, 255, 255}});
    EXPECT_EQ(read_free_mask(folder.path() / "rgb.png").is_free, (std::vector<std::uint8_t>{1, 1}));
    write_png(folder.path() / "red.png", Image{{1, 1, 3, 255}, {255, 0, 0}});
    EXPECT_EQ(read_free_mask(folder.path() / "red.png").is_free, (std::vector<std::uint8_t>{0}));
}

TEST(LabelImage, IsWrittenUprightWithSixteenBits) {
    const ScratchFolder folder;
    Raster<std::uint16_t> labels({-3, 5}, 2, 2);
    labels.values = {1, 2, 300, 65'535};
    folder.write("rooms.png", encode_label_png(labels));
    const Image image = read_image(folder.path() / "rooms.png");
    EXPECT_EQ(image.header, (ImageHeader{2, 2, 1, 65535}));
    EXPECT_EQ(image.samples, (std::vector<std::uint16_t>{300, 65'535, 1, 2}));
}

TEST(LabelImage, NamesAFileThatIsNoImage) {
    const ScratchFolder folder;
    const auto path = folder.write("text.png", "no image");
    EXPECT_NE(test::error_of([&] { (void)read_label_image(path); }).find("text.png"),
              std::string::npos);
}

}  // namespace
}  // namespace quadcut::io
