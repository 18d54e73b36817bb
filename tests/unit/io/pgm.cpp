// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/image.hpp"
#include "tests/unit/io/gzip.hpp"
#include "tests/unit/io/scratch.hpp"

// Where the pixels of a P5 begin, which the standard says and programs do otherwise.

namespace quadcut::io {
namespace {

struct Parsed {
    std::string pixels;
    std::size_t num_warnings = 0;
};

Parsed parse(const std::string& bytes) {
    Parsed parsed;
    const auto keep = [&](const ImageHeader&, std::int32_t, auto row) {
        for (const std::uint16_t sample : row) parsed.pixels += static_cast<char>(sample);
    };
    parsed.num_warnings = parse_image(bytes, "x.pgm", keep).warnings.size();
    return parsed;
}

void expect_read(const std::string& header, const std::string& pixels, const std::string& surplus) {
    const Parsed parsed = parse(header + pixels + surplus);
    EXPECT_EQ(parsed.pixels, pixels) << header << surplus;
    EXPECT_EQ(parsed.num_warnings, surplus.empty() ? 0U : 1U) << header << surplus;
}

const std::string kWalls("\0\0\xCD\xFE\xFE\0", 6);

/// Headers of 3 x 2 pixels.
const std::vector<std::string> kHeaders = {
    "P5\n3 2\n255\n",
    "P5 3 2 255 ",
    "P5\r\n3 2\r\n255\r\n",
    "P5\n3 2\n255\n# a comment\n",
    "P5\n3 2\n255\n# one\n# and another\n",
    "P5\n3 2\n255# at once\n",
    "P5\n3 2\n255 # on the line\n",
    "P5\r\n3 2\r\n255\r\n# a comment\r\n",
};

TEST(PgmRaster, BeginsWhereItEndsWithTheFile) {
    for (const std::string& header : kHeaders) expect_read(header, kWalls, "");
    expect_read("P5\n3 2\n255\r\n", kWalls, "");
    expect_read("P5\n3 2\n255 \n", kWalls, "");
}

TEST(PgmRaster, SurplusBytesAreAWarning) {
    for (const std::string& header : kHeaders) {
        expect_read(header, kWalls, "\n");
        expect_read(header, kWalls, "\0\0\0");
        expect_read(header, kWalls, std::string(100, '\xFE'));
    }
    const auto ignore = [](const ImageHeader&, std::int32_t, auto) {};
    EXPECT_EQ(parse_image(kHeaders[0] + kWalls + "ab", "x.pgm", ignore).warnings,
              std::vector<std::string>{
                  "the file goes on after the image for 2 bytes, which are ignored"});
    EXPECT_EQ(parse_image("P2 1 1 255 7 \n 8", "x.pgm", ignore).warnings.size(), 1U);
    EXPECT_EQ(parse_image("P2 1 1 255 7 \n # end\n", "x.pgm", ignore).warnings.size(), 0U);
}

TEST(PgmRaster, PixelsMayLookLikeAHeader) {
    for (const std::string pixels :
         {"\n\n\n\n\n\n", "# one\n", "\r\n# a\n", "#\n#\n#\n", "      ", "\n#\n\n\n\n"}) {
        expect_read(kHeaders[0], pixels, "");
        expect_read(kHeaders[2], pixels, "");
        expect_read("P5 3 2 255\r", pixels, "");
    }
    expect_read(kHeaders[0], "\n\n\n\n\n\n", "\n");
    expect_read(kHeaders[0], std::string("#\xFE\n\0\0\0", 6), "\n");
}

TEST(PgmRaster, AShortFileIsRefusedWhateverStandsBefore) {
    for (const std::string& header : kHeaders) {
        for (std::size_t missing = 1; missing <= kWalls.size(); ++missing) {
            const std::string cut = header + kWalls.substr(missing);
            // With one byte less, the second of a line end is taken for a pixel: it fits.
            if (missing == 1 && header.ends_with("255\r\n")) continue;
            EXPECT_EQ(test::error_of([&] { parse(cut); }).find("x.pgm: byte "), 0U) << cut;
        }
    }
}

TEST(Pgm, GzipMayNotStandForMoreThanTheHeaderSays) {
    const std::string bomb = test::gzip(kHeaders[0] + std::string(std::size_t{1} << 25U, '\0'));
    EXPECT_NE(test::error_of([&] { parse(bomb); }).find("x.pgm: unpacks to more than the 1048"),
              std::string::npos);
    EXPECT_EQ(parse(test::gzip(kHeaders[0] + kWalls + "ab")).num_warnings, 1U);
    EXPECT_EQ(test::error_of([] { parse(test::gzip("P5 70000 70000 255\n")); }),
              "x.pgm: byte 18: the image has 70000 x 70000 pixels, more than the 1073741824 that "
              "are read at most");
}

}  // namespace
}  // namespace quadcut::io
