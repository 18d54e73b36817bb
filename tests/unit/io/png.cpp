// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "io/image.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

// The PNG that quadcut does not write itself, made by libpng directly.

namespace quadcut::io {
namespace {

using test::error_of;

struct PngForm {
    int width = 0;
    int height = 0;
    int depth = 8;
    int color_type = PNG_COLOR_TYPE_GRAY;
    int interlace = PNG_INTERLACE_NONE;
    std::vector<png_color> palette = {};
    std::vector<png_byte> alpha = {};  ///< of the palette's entries
    int transparent_grey = -1;
};

std::string make_png(const PngForm& form, std::vector<std::vector<png_byte>> packed_rows) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp p, png_bytep data, std::size_t count) {
            static_cast<std::string*>(png_get_io_ptr(p))
                ->append(reinterpret_cast<const char*>(data), count);
        },
        nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(form.width),
                 static_cast<png_uint_32>(form.height), form.depth, form.color_type, form.interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!form.palette.empty()) {
        png_set_PLTE(png, info, form.palette.data(), static_cast<int>(form.palette.size()));
    }
    if (!form.alpha.empty()) {
        png_set_tRNS(png, info, form.alpha.data(), static_cast<int>(form.alpha.size()), nullptr);
    }
    if (form.transparent_grey >= 0) {
        png_color_16 color{};
        color.gray = static_cast<png_uint_16>(form.transparent_grey);
        png_set_tRNS(png, info, nullptr, 0, &color);
    }
    std::vector<png_bytep> rows;
    for (auto& row : packed_rows) rows.push_back(row.data());
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

Image parse(std::string_view bytes) {
    Image image;
    std::int32_t expected_row = 0;
    const auto keep_row = [&](const ImageHeader&, std::int32_t y, auto row) {
        EXPECT_EQ(y, expected_row++);
        image.samples.insert(image.samples.end(), row.begin(), row.end());
    };
    image.header = parse_image(bytes, "x.png", keep_row).header;
    return image;
}

using Samples = std::vector<std::uint16_t>;

TEST(Png, ExpandsFewBitsToEight) {
    const Image one = parse(make_png({.width = 3, .height = 1, .depth = 1}, {{0b10100000}}));
    EXPECT_EQ(one.header, (ImageHeader{3, 1, 1, 255}));
    EXPECT_EQ(one.samples, (Samples{255, 0, 255}));
    const Image two = parse(make_png({.width = 4, .height = 1, .depth = 2}, {{0b00011011}}));
    EXPECT_EQ(two.samples, (Samples{0, 85, 170, 255}));
    const Image four = parse(make_png({.width = 2, .height = 1, .depth = 4}, {{0x1f}}));
    EXPECT_EQ(four.samples, (Samples{17, 255}));
}

TEST(Png, ExpandsPalettes) {
    PngForm form{.width = 2, .height = 2, .color_type = PNG_COLOR_TYPE_PALETTE};
    form.palette = {{1, 2, 3}, {4, 5, 6}};
    const Image opaque = parse(make_png(form, {{0, 1}, {1, 1}}));
    EXPECT_EQ(opaque.header, (ImageHeader{2, 2, 3, 255}));
    EXPECT_EQ(opaque.samples, (Samples{1, 2, 3, 4, 5, 6, 4, 5, 6, 4, 5, 6}));
    form.alpha = {0};
    const Image clear = parse(make_png(form, {{0, 1}, {1, 1}}));
    EXPECT_EQ(clear.header.channels, 4);
    EXPECT_EQ(clear.row(0)[3], 0);
    EXPECT_EQ(clear.row(0)[7], 255);
}

TEST(Png, MakesAChannelOfATransparentGrey) {
    const Image image = parse(make_png({.width = 2, .height = 1, .transparent_grey = 7}, {{7, 8}}));
    EXPECT_EQ(image.header.channels, 2);
    EXPECT_EQ(image.samples, (Samples{7, 0, 8, 255}));
}

TEST(Png, ReadsWordsInNetworkOrder) {
    const Image image = parse(make_png({.width = 1, .height = 1, .depth = 16}, {{0x12, 0x34}}));
    EXPECT_EQ(image.header.max_value, 65535);
    EXPECT_EQ(image.samples, Samples{0x1234});
}

TEST(Png, InterlacedEqualsPlain) {
    std::vector<std::vector<png_byte>> rows(9, std::vector<png_byte>(11));
    for (std::size_t y = 0; y < rows.size(); ++y) {
        for (std::size_t x = 0; x < rows[y].size(); ++x) {
            rows[y][x] = static_cast<png_byte>(y * 20 + x);
        }
    }
    PngForm form{.width = 11, .height = 9};
    const Image plain = parse(make_png(form, rows));
    form.interlace = PNG_INTERLACE_ADAM7;
    const Image interlaced = parse(make_png(form, rows));
    EXPECT_EQ(interlaced.header, plain.header);
    EXPECT_EQ(interlaced.samples, plain.samples);
    EXPECT_EQ(plain.row(8)[10], 170);
}

TEST(Png, RefusesEveryCutAndEveryFlippedBit) {
    std::vector<std::vector<png_byte>> rows(8, std::vector<png_byte>(8, 9));
    rows[3][4] = 200;
    const std::string bytes = make_png({.width = 8, .height = 8}, rows);
    ASSERT_EQ(parse(bytes).row(3)[4], 200);
    for (std::size_t length = 4; length < bytes.size(); ++length) {
        const std::string cut = bytes.substr(0, length);
        EXPECT_NE(error_of([&] { parse(cut); }).find("x.png: byte "), std::string::npos) << length;
    }
    for (std::size_t i = 4; i < bytes.size(); ++i) {
        std::string flipped = bytes;
        flipped[i] = static_cast<char>(flipped[i] ^ 0x10);
        // A damaged check sum of a chunk that is needed must not pass unseen.
        EXPECT_NE(error_of([&] { parse(flipped); }), "no error") << i;
    }
}

TEST(Png, WarnsOfSurplusBytes) {
    const std::string bytes = make_png({.width = 1, .height = 1}, {{7}});
    const ImageRowSink ignore = [](const ImageHeader&, std::int32_t, auto) {};
    EXPECT_TRUE(parse_image(bytes, "x.png", ignore).warnings.empty());
    EXPECT_EQ(parse_image(bytes + "ab", "x.png", ignore).warnings,
              std::vector<std::string>{
                  "the file goes on after the image for 2 bytes, which are ignored"});
}

TEST(Png, RefusesAHeaderThatTheBytesCannotHold) {
    std::string bytes = make_png({.width = 8, .height = 8}, std::vector<std::vector<png_byte>>(
                                                                8, std::vector<png_byte>(8, 9)));
    const auto set_size = [&](std::uint32_t width, std::uint32_t height) {
        for (int i = 0; i < 4; ++i) {
            bytes[static_cast<std::size_t>(16 + i)] = static_cast<char>(width >> (24 - 8 * i));
            bytes[static_cast<std::size_t>(20 + i)] = static_cast<char>(height >> (24 - 8 * i));
        }
        std::uint32_t crc = 0xffffffffU;  // Of the chunk's name and its 13 bytes.
        for (std::size_t i = 12; i < 29; ++i) {
            crc ^= static_cast<unsigned char>(bytes[i]);
            for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ (0xedb88320U & (0U - (crc & 1U)));
        }
        for (int i = 0; i < 4; ++i) {
            bytes[static_cast<std::size_t>(29 + i)] = static_cast<char>(~crc >> (24 - 8 * i));
        }
    };
    set_size(1'000'000'000, 1'000'000'000);
    EXPECT_EQ(error_of([&] { parse(bytes); }),
              "x.png: the image has 1000000000 x 1000000000 pixels, more than the 1073741824 that "
              "are read at most");
    set_size(30'000, 30'000);
    EXPECT_EQ(error_of([&] { parse(bytes); }),
              "x.png: the PNG's header promises 30000 x 30000 pixels, more than " +
                  std::to_string(bytes.size()) + " bytes can hold");
    set_size(8, 9);
    EXPECT_NE(error_of([&] { parse(bytes); }).find("damaged PNG"), std::string::npos);
}

}  // namespace
}  // namespace quadcut::io
