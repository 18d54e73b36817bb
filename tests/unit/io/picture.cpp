// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/picture.hpp"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/io/parsed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using namespace std::string_literals;

using test::error_of;
using Samples = std::vector<std::uint16_t>;

using test::Parsed;

Parsed parse(const std::string& bytes) { return test::parse(bytes, "x.img"); }

std::string little(std::uint32_t value, int num_bytes) {
    std::string bytes;
    for (int i = 0; i < num_bytes; ++i) bytes += static_cast<char>(i < 4 ? value >> (8 * i) : 0);
    return bytes;
}

struct BmpForm {
    std::int32_t width = 0;
    std::int32_t height = 0;
    unsigned bits = 24;
    std::string palette = {};
};

std::string make_bmp(const BmpForm& form, const std::string& pixels) {
    const auto offset = static_cast<std::uint32_t>(54 + form.palette.size());
    return "BM" + little(offset + static_cast<std::uint32_t>(pixels.size()), 4) + little(0, 4) +
           little(offset, 4) + little(40, 4) + little(static_cast<std::uint32_t>(form.width), 4) +
           little(static_cast<std::uint32_t>(form.height), 4) + little(1, 2) +
           little(form.bits, 2) + little(0, 24) + form.palette + pixels;
}

const std::string kTwoColors("\x01\x02\x03\0\xFE\xFD\xFC\0", 8);  // Blue first.

TEST(Picture, ReadsBmp) {
    // The lowest row first, rows of four bytes.
    const Parsed colors = parse(make_bmp({1, 2}, "\x01\x02\x03\0\x04\x05\x06\0"s));
    EXPECT_EQ(colors.header, (ImageHeader{1, 2, 3, 255}));
    EXPECT_EQ(colors.samples, (Samples{6, 5, 4, 3, 2, 1}));
    EXPECT_TRUE(colors.warnings.empty());
    const Parsed from_top = parse(make_bmp({1, -2}, "\x01\x02\x03\0\x04\x05\x06\0"s));
    EXPECT_EQ(from_top.samples, (Samples{3, 2, 1, 6, 5, 4}));
    const Parsed bits = parse(make_bmp({3, 1, 1, kTwoColors}, "\x40\0\0\0"s));
    EXPECT_EQ(bits.samples, (Samples{3, 2, 1, 0xFC, 0xFD, 0xFE, 3, 2, 1}));
    const Parsed bytes = parse(make_bmp({2, 1, 8, kTwoColors}, "\1\0\0\0"s));
    EXPECT_EQ(bytes.samples, (Samples{0xFC, 0xFD, 0xFE, 3, 2, 1}));
}

TEST(Picture, RefusesABmpThatIsDamaged) {
    const std::string whole = make_bmp({2, 2, 8, kTwoColors}, std::string(8, '\0'));
    ASSERT_EQ(parse(whole).samples.size(), 12U);
    for (std::size_t length = 1; length < whole.size(); ++length) {
        EXPECT_NE(error_of([&] { parse(whole.substr(0, length)); }), "no error") << length;
    }
    EXPECT_EQ(error_of([&] {
                  parse(make_bmp({2, 1, 8, kTwoColors}, "\1\2\0\0"s));
              }),
              "x.img: damaged BMP: a pixel's colour is not among the 2 of the palette");
    EXPECT_EQ(error_of([&] {
                  parse(make_bmp({100'000, 100'000}, "1234"));
              }),
              "x.img: the image has 100000 x 100000 pixels, more than the 268435456 that are read "
              "at most of a BMP");
    EXPECT_EQ(error_of([&] {
                  parse(make_bmp({10'000, 10'000}, "1234"));
              }),
              "x.img: the BMP's header promises 10000 x 10000 pixels, more than 58 bytes can hold");
    EXPECT_EQ(error_of([&] {
                  parse(make_bmp({0, 1}, "1234"));
              }),
              "x.img: the image has 0 x 1 pixels, expected at least one");
}

/// A GIF whose codes are never longer than three bits: the table is cleared after each pixel.
std::string make_gif(std::uint16_t width, std::uint16_t height, const std::string& pixels) {
    std::string codes;
    unsigned bits = 0;
    unsigned num_bits = 0;
    const auto add = [&](unsigned code) {
        bits |= code << num_bits;
        for (num_bits += 3; num_bits >= 8; num_bits -= 8, bits >>= 8U) {
            codes += static_cast<char>(bits);
        }
    };
    for (const char pixel : pixels) {
        add(4);  // Clear.
        add(static_cast<unsigned>(pixel));
    }
    add(5);  // End.
    codes += static_cast<char>(bits);
    const std::string size = little(width, 2) + little(height, 2);
    return "GIF89a" + size + "\x81\0\0"s + "\0\0\0\x0A\x0B\x0C\xCD\xCD\xCD\xFE\xFE\xFE"s +
           "\x21\xFE\x02hi\0"s + "\x2C\0\0\0\0"s + size + "\0\x02"s +
           static_cast<char>(codes.size()) + codes + "\0;"s;
}

TEST(Picture, ReadsGif) {
    const Parsed gif = parse(make_gif(2, 2, "\0\1\2\3"s));
    EXPECT_EQ(gif.header, (ImageHeader{2, 2, 4, 255}));
    EXPECT_EQ(gif.samples,
              (Samples{0, 0, 0, 255, 10, 11, 12, 255, 205, 205, 205, 255, 254, 254, 254, 255}));
    EXPECT_TRUE(gif.warnings.empty());
    EXPECT_EQ(parse(make_gif(1, 1, "\1") + "x").warnings.size(), 1U);
}

TEST(Picture, RefusesAGifThatIsDamaged) {
    const std::string whole = make_gif(2, 2, "\0\1\2\3"s);
    for (std::size_t length = 6; length < whole.size(); ++length) {
        EXPECT_NE(error_of([&] { parse(whole.substr(0, length)); }), "no error") << length;
    }
    EXPECT_EQ(error_of([&] { parse(make_gif(65'535, 65'535, "\1")); }),
              "x.img: the image has 65535 x 65535 pixels, more than the 268435456 that are read at "
              "most of a GIF");
    EXPECT_EQ(error_of([&] {
                  parse(make_gif(10'000, 10'000, "\1"));
              }).find("x.img: the GIF's header promises 10000 x 10000 pixels, more than "),
              0U);
}

}  // namespace
}  // namespace quadcut::io
