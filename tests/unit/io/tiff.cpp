// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/tiff.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <tiffio.h>

#include "io/file.hpp"
#include "tests/unit/io/parsed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;
using Samples = std::vector<std::uint16_t>;

struct Form {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int bits = 8;
    int samples = 1;
    int photometric = PHOTOMETRIC_MINISBLACK;
    int compression = COMPRESSION_NONE;
    std::uint32_t tile_side = 0;
    int format = SAMPLEFORMAT_UINT;
    bool has_alpha = false;
};

/// A TIFF written by libtiff: the bytes of its rows, or of its tiles.
std::string make_tiff(const Form& form, const std::vector<std::string>& blocks) {
    const ScratchFolder folder;
    const std::string path = folder.path() / "a.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, form.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, form.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, form.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.samples);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, form.photometric);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, form.compression);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, form.format);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    if (form.has_alpha) {
        const std::uint16_t kind = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &kind);
    }
    if (form.photometric == PHOTOMETRIC_PALETTE) {
        std::vector<std::uint16_t> parts(std::size_t{1} << form.bits);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i] = static_cast<std::uint16_t>(i * 0x4001);
        }
        TIFFSetField(tiff, TIFFTAG_COLORMAP, parts.data(), parts.data(), parts.data());
    }
    if (form.tile_side > 0) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, form.tile_side);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, form.tile_side);
    }
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        std::string block = blocks[i];
        if (form.tile_side > 0) {
            TIFFWriteEncodedTile(tiff, i, block.data(), static_cast<tmsize_t>(block.size()));
        } else {
            TIFFWriteScanline(tiff, block.data(), i, 0);
        }
    }
    TIFFClose(tiff);
    return read_file(path);
}

using test::Parsed;

Parsed parse(const std::string& bytes) { return test::parse(bytes, "x.tif"); }

TEST(Tiff, ReadsGreysOfAnyDepth) {
    const Parsed bytes = parse(make_tiff({3, 2}, {std::string("\0\xCD\xFE", 3), "abc"}));
    EXPECT_EQ(bytes.header, (ImageHeader{3, 2, 1, 255}));
    EXPECT_EQ(bytes.samples, (Samples{0, 205, 254, 'a', 'b', 'c'}));
    EXPECT_TRUE(bytes.warnings.empty());
    EXPECT_EQ(parse(make_tiff({3, 1, 1}, {"\xA0"})).samples, (Samples{255, 0, 255}));
    EXPECT_EQ(parse(make_tiff({4, 1, 2}, {"\x1B"})).samples, (Samples{0, 85, 170, 255}));
    EXPECT_EQ(parse(make_tiff({2, 1, 4}, {"\x1F"})).samples, (Samples{17, 255}));
    const Parsed words = parse(make_tiff({2, 1, 16}, {"\x34\x12\xFF\xFF"}));
    EXPECT_EQ(words.header.max_value, 65535);
    EXPECT_EQ(words.samples, (Samples{0x1234, 0xFFFF}));
}

TEST(Tiff, TurnsAroundWhereWhiteIsZero) {
    const Form bits{3, 1, 1, 1, PHOTOMETRIC_MINISWHITE};
    EXPECT_EQ(parse(make_tiff(bits, {"\xA0"})).samples, (Samples{0, 255, 0}));
    const Form bytes{2, 1, 8, 1, PHOTOMETRIC_MINISWHITE};
    EXPECT_EQ(parse(make_tiff(bytes, {"\x01\xFF"})).samples, (Samples{254, 0}));
}

TEST(Tiff, ReadsColorsPalettesAndAlpha) {
    const Form colors{1, 1, 8, 3, PHOTOMETRIC_RGB};
    EXPECT_EQ(parse(make_tiff(colors, {"\1\2\3"})).samples, (Samples{1, 2, 3}));
    Form clear{1, 1, 8, 4, PHOTOMETRIC_RGB};
    clear.has_alpha = true;
    const Parsed four = parse(make_tiff(clear, {"\1\2\3\4"}));
    EXPECT_EQ(four.header.channels, 4);
    EXPECT_EQ(four.samples, (Samples{1, 2, 3, 4}));
    Form grey{2, 1, 8, 2};
    grey.has_alpha = true;
    EXPECT_EQ(parse(make_tiff(grey, {"\1\2\3\4"})).samples, (Samples{1, 2, 3, 4}));
    const Form palette{2, 1, 2, 1, PHOTOMETRIC_PALETTE};
    EXPECT_EQ(parse(make_tiff(palette, {"\x10"})).samples, (Samples{0, 0, 0, 0x40, 0x40, 0x40}));
}

TEST(Tiff, ReadsStripsInAnyCompression) {
    std::vector<std::string> rows;
    Samples expected;
    for (int y = 0; y < 40; ++y) {
        std::string& row = rows.emplace_back(100, '\xFE');
        row[static_cast<std::size_t>(y)] = '\0';
        for (const char c : row) expected.push_back(static_cast<unsigned char>(c));
    }
    for (const int compression :
         {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_PACKBITS, COMPRESSION_ADOBE_DEFLATE}) {
        Form form{100, 40};
        form.compression = compression;
        EXPECT_EQ(parse(make_tiff(form, rows)).samples, expected) << compression;
    }
}

TEST(Tiff, ReadsTiles) {
    Form form{20, 17};
    form.tile_side = 16;
    const std::vector<std::string> tiles = {std::string(256, 'a'), std::string(256, 'b'),
                                            std::string(256, 'c'), std::string(256, 'd')};
    const Parsed parsed = parse(make_tiff(form, tiles));
    EXPECT_EQ(parsed.header, (ImageHeader{20, 17, 1, 255}));
    ASSERT_EQ(parsed.samples.size(), 340U);
    EXPECT_EQ(parsed.samples[15], 'a');
    EXPECT_EQ(parsed.samples[16], 'b');
    EXPECT_EQ(parsed.samples[16 * 20], 'c');
    EXPECT_EQ(parsed.samples[339], 'd');
}

TEST(Tiff, NamesWhatIsNotRead) {
    Form floats{1, 1, 32};
    floats.format = SAMPLEFORMAT_IEEEFP;
    EXPECT_EQ(error_of([&] { parse(make_tiff(floats, {"1234"})); }),
              "x.tif: the TIFF has floating-point numbers, which are not read; save it as a PNG of "
              "8 bits");
    const Form ink{1, 1, 8, 4, PHOTOMETRIC_SEPARATED};
    EXPECT_NE(error_of([&] { parse(make_tiff(ink, {"1234"})); }).find("neither grey nor RGB"),
              std::string::npos);
}

TEST(Tiff, RefusesEveryCut) {
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW}) {
        Form form{20, 20};
        form.compression = compression;
        std::vector<std::string> rows;
        for (int y = 0; y < 20; ++y) rows.push_back(std::string(20, static_cast<char>(11 * y)));
        const std::string whole = make_tiff(form, rows);
        ASSERT_EQ(parse(whole).samples.size(), 400U);
        // Its last four bytes say that there is no other page.
        for (std::size_t length = 4; length < whole.size() - 4; ++length) {
            EXPECT_NE(error_of([&] { parse(whole.substr(0, length)); }).find("x.tif: "),
                      std::string::npos)
                << length;
        }
    }
}

/// A TIFF of one strip with nothing in it.
std::string empty_tiff(std::uint32_t side, std::uint32_t compression) {
    const auto little = [](std::uint32_t value, int num_bytes) {
        std::string bytes;
        for (int i = 0; i < num_bytes; ++i) bytes += static_cast<char>(value >> (8 * i));
        return bytes;
    };
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> entries = {
        {TIFFTAG_IMAGEWIDTH, side},         {TIFFTAG_IMAGELENGTH, side}, {TIFFTAG_BITSPERSAMPLE, 8},
        {TIFFTAG_COMPRESSION, compression}, {TIFFTAG_PHOTOMETRIC, 1},    {TIFFTAG_STRIPOFFSETS, 8},
        {TIFFTAG_ROWSPERSTRIP, side},       {TIFFTAG_STRIPBYTECOUNTS, 1}};
    std::string bytes = "II*" + little(0, 1) + little(8, 4);
    bytes += little(static_cast<std::uint32_t>(entries.size()), 2);
    for (const auto& [tag, value] : entries) {
        bytes += little(tag, 2) + little(TIFF_LONG, 2) + little(1, 4) + little(value, 4);
    }
    return bytes + little(0, 4);
}

TEST(Tiff, RefusesAHeaderThatTheBytesCannotHold) {
    for (const std::uint32_t compression : {COMPRESSION_NONE, COMPRESSION_LZW}) {
        EXPECT_EQ(error_of([&] { parse(empty_tiff(200'000, compression)); }),
                  "x.tif: the image has 200000 x 200000 pixels, more than the 1073741824 that are "
                  "read at most");
        EXPECT_EQ(error_of([&] { parse(empty_tiff(30'000, compression)); }),
                  "x.tif: the TIFF's header promises 30000 x 30000 pixels, more than 110 bytes can "
                  "hold");
    }
}

}  // namespace
}  // namespace quadcut::io
