// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/image.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

Image parse(std::string_view bytes) {
    Image image;
    const auto keep_row = [&](const ImageHeader&, std::int32_t, auto row) {
        image.samples.insert(image.samples.end(), row.begin(), row.end());
    };
    image.header = parse_image(bytes, "x.pgm", keep_row).header;
    return image;
}

std::string pgm_error(std::string_view bytes) {
    return error_of([&] { parse(bytes); });
}

using Samples = std::vector<std::uint16_t>;

Image counting_image(int width, int height, int channels, int max_value) {
    Image image{{width, height, channels, max_value}, {}};
    image.samples.resize(image.header.row_samples() * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        image.samples[i] =
            static_cast<std::uint16_t>(i * 7919 % (static_cast<std::size_t>(max_value) + 1));
    }
    return image;
}

ImageRowSource rows_of(const Image& image) {
    return [&image](std::int32_t y, std::span<std::uint16_t> samples) {
        const auto row = image.row(y);
        std::copy(row.begin(), row.end(), samples.begin());
    };
}

TEST(Pgm, ReadsTextWithCommentsAnywhere) {
    const Image image = parse("P2 # magic\n#size\n3 2\n# largest\n15\n0 1 2\n# row\n13 14 15");
    EXPECT_EQ(image.header, (ImageHeader{3, 2, 1, 15}));
    EXPECT_EQ(image.samples, (Samples{0, 1, 2, 13, 14, 15}));
}

TEST(Pgm, ReadsBytes) {
    const Image image = parse(std::string_view("P5\n# CREATOR\n2 2 255\n\x00\x0a#\xff", 25));
    EXPECT_EQ(image.header, (ImageHeader{2, 2, 1, 255}));
    EXPECT_EQ(image.samples, (Samples{0, 10, '#', 255}));
}

TEST(Pgm, ReadsWordsInNetworkOrder) {
    const Image image = parse(std::string_view("P5 2 1 65535\n\x01\x02\xff\xff", 17));
    EXPECT_EQ(image.header.max_value, 65535);
    EXPECT_EQ(image.samples, (Samples{0x0102, 0xffff}));
    // From 256 on a sample takes two bytes.
    EXPECT_EQ(parse(std::string_view("P5 1 1 256\n\x01\x00", 13)).samples, Samples{256});
}

TEST(Pgm, NamesWhatIsMissing) {
    EXPECT_EQ(pgm_error("P5"),
              "x.pgm: byte 2: the file ends where the width of the PGM was expected");
    EXPECT_EQ(pgm_error("P5 10 x"),
              "x.pgm: byte 6: expected the height of the PGM, a whole number");
    EXPECT_EQ(pgm_error("P5 4 4 255\n12345"),
              "x.pgm: byte 11: expected 16 bytes of pixels after the PGM's header, found 5");
    EXPECT_EQ(pgm_error("P2 2 2 255\n1 2 3    "),
              "x.pgm: byte 20: the file ends where a pixel of the PGM was expected");
    EXPECT_EQ(pgm_error("P2 2 2 255\n1 -2 3 4"),
              "x.pgm: byte 13: expected a pixel of the PGM, a whole number");
    EXPECT_EQ(pgm_error("P5 1 1 255"),
              "x.pgm: byte 10: expected one white space before the pixels of the PGM");
}

TEST(Pgm, NamesWhatIsOutOfRange) {
    EXPECT_EQ(pgm_error("P5 0 4 255\n"),
              "x.pgm: byte 10: the image has 0 x 4 pixels, expected at least one");
    EXPECT_EQ(pgm_error("P5 4 4 70000\n"),
              "x.pgm: byte 12: the largest grey value is 70000, expected 1 to 65535");
    EXPECT_EQ(pgm_error("P2 2 1 9\n3 10"),
              "x.pgm: byte 13: the pixel in column 1, row 0 is 10, over the header's largest "
              "value 9");
}

TEST(Pgm, RefusesAHugeHeaderBeforeItAllocates) {
    EXPECT_EQ(pgm_error("P5 1000000000 1000000000 255\n"),
              "x.pgm: byte 28: the image has 1000000000 x 1000000000 pixels, more than the "
              "1073741824 that are read at most");
    EXPECT_EQ(pgm_error("P5 99999999999999999999 1 255\n").find("x.pgm: byte 29: the image has"),
              0U);
    // Within the limit, but not in the file.
    EXPECT_EQ(pgm_error("P5 30000 30000 65535\nx"),
              "x.pgm: byte 21: expected 1800000000 bytes of pixels after the PGM's header, found "
              "1");
    EXPECT_EQ(pgm_error("P2 30000 30000 255\n1 2"),
              "x.pgm: byte 18: expected 1799999999 or more bytes of pixels after the PGM's "
              "header, found 4");
}

TEST(Pgm, WritesWhatItReads) {
    for (const int max_value : {1, 255, 256, 65535}) {
        const Image image = counting_image(5, 3, 1, max_value);
        const Image again = parse(encode_pgm(image.header, rows_of(image)));
        EXPECT_EQ(again.header, image.header);
        EXPECT_EQ(again.samples, image.samples);
    }
}

TEST(Image, RefusesOtherFormatsAndSaysWhatTheyAre) {
    const std::string expected = "expected an image (PNG, PGM, TIFF, BMP, JPEG, GIF)";
    EXPECT_EQ(pgm_error(""), "x.pgm: the file is empty, " + expected);
    EXPECT_EQ(pgm_error("P6 1 1 255\nabc"), "x.pgm: is a PPM image, " + expected +
                                                "; save it as a PNG (any picture program does)");
    EXPECT_EQ(pgm_error("#ROSBAG V2.0\n").find("x.pgm: is a ROS 1 bag, " + expected), 0U);
    EXPECT_EQ(pgm_error("FLASER 1 1.0 0 0 0 0 0 0 1 host 1\n").find("x.pgm: is a laser log, "), 0U);
    EXPECT_EQ(pgm_error("\x01\x02\x03"), "x.pgm: is of no kind that is known, " + expected);
}

TEST(Image, WritesAndReadsFiles) {
    const ScratchFolder folder;
    for (const int channels : {1, 2, 3, 4}) {
        for (const int max_value : {255, 65535}) {
            const Image image = counting_image(13, 7, channels, max_value);
            const auto path = folder.path() / "a.png";
            write_png(path, image);
            const Image again = read_image(path);
            EXPECT_EQ(again.header, image.header);
            EXPECT_EQ(again.samples, image.samples);
        }
    }
    const Image grey = counting_image(4, 4, 1, 65535);
    write_pgm(folder.path() / "a.pgm", grey.header, rows_of(grey));
    EXPECT_EQ(read_image(folder.path() / "a.pgm").samples, grey.samples);
    EXPECT_EQ(folder.names().size(), 2U);
}

TEST(Image, APngIsTheSameOnAnyNumberOfThreads) {
    const test::ScratchFolder folder;
    for (const int max_value : {255, 65535}) {
        const Image image =
            counting_image(150, 201, 3, max_value);  // Four bands, the last not full.
        const std::string bytes = encode_png(image.header, rows_of(image));
        EXPECT_EQ(encode_png(image.header, rows_of(image), Executor{3}), bytes);
        const Image again = read_image(folder.write("a.png", bytes));
        EXPECT_EQ(again.header, image.header);
        EXPECT_EQ(again.samples, image.samples);
    }
}

TEST(Image, ReadingNamesTheFile) {
    EXPECT_EQ(error_of([] { (void)read_image("/nowhere.png"); }),
              "/nowhere.png: cannot be opened: No such file or directory");
}

TEST(Image, EncodingRefusesWhatAFormatCannotHold) {
    const ImageRowSource nothing = [](std::int32_t, std::span<std::uint16_t>) {};
    EXPECT_THROW((void)encode_png({0, 1, 1, 255}, nothing), std::logic_error);
    EXPECT_THROW((void)encode_png({1, 1, 5, 255}, nothing), std::logic_error);
    EXPECT_THROW((void)encode_png({1, 1, 1, 100}, nothing), std::logic_error);
    EXPECT_THROW((void)encode_pgm({1, 1, 3, 255}, nothing), std::logic_error);
}

}  // namespace
}  // namespace quadcut::io
