// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/line_reader.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/io/gzip.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::gzip;

std::vector<std::string> lines_of(std::string_view bytes, LineLimits limits = {}) {
    LineReader reader(bytes, "x.log", limits);
    std::vector<std::string> lines;
    while (const auto line = reader.next()) {
        EXPECT_EQ(line->number, lines.size() + 1);
        lines.emplace_back(line->text);
        if (line->too_long) lines.back() += " (too long)";
        if (!line->ended) lines.back() += " (no end)";
    }
    return lines;
}

using Lines = std::vector<std::string>;

TEST(LineReader, SplitsAtBothKindsOfLineEnd) {
    EXPECT_EQ(lines_of(""), Lines{});
    EXPECT_EQ(lines_of("\n"), Lines{""});
    EXPECT_EQ(lines_of("a\r\n\nb\n"), (Lines{"a", "", "b"}));
    EXPECT_EQ(lines_of("a\nb"), (Lines{"a", "b (no end)"}));
}

TEST(LineReader, LeavesOutAByteOrderMark) {
    EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                       "a\r\n\xEF\xBB\xBF"
                       "b\n"),
              (Lines{"a",
                     "\xEF\xBB\xBF"
                     "b"}));
    EXPECT_EQ(lines_of(gzip("\xEF\xBB\xBF"
                            "a\n")),
              Lines{"a"});
}

TEST(LineReader, KeepsNulBytes) {
    EXPECT_EQ(lines_of(std::string_view("a\0b\n", 4)), Lines{std::string("a\0b", 3)});
}

TEST(LineReader, CutsLinesThatAreTooLong) {
    const LineLimits limits{.max_line_bytes = 4};
    EXPECT_EQ(lines_of("1234\n12345\n1\n123456789", limits),
              (Lines{"1234", "1234 (too long)", "1", "1234 (too long) (no end)"}));
}

TEST(LineReader, UnpacksGzipByContent) {
    EXPECT_EQ(lines_of(gzip("a\r\n\nb\nc")), (Lines{"a", "", "b", "c (no end)"}));
    EXPECT_EQ(lines_of(gzip("")), Lines{});
}

TEST(LineReader, LinesSpanPiecesOfTheUnpackedBytes) {
    std::string text;
    Lines expected;
    for (int i = 0; i < 2000; ++i) {
        expected.push_back(std::to_string(i) + std::string(static_cast<std::size_t>(i), 'x'));
        text += expected.back() + "\n";
    }
    EXPECT_EQ(lines_of(gzip(text)), expected);
    EXPECT_EQ(lines_of(text), expected);
}

TEST(LineReader, ReadsJoinedGzipFilesAndIgnoresPadding) {
    EXPECT_EQ(lines_of(gzip("a\nb") + gzip("c\nd\n")), (Lines{"a", "bc", "d"}));
    EXPECT_EQ(lines_of(gzip("a\n") + std::string(512, '\0')), Lines{"a"});
}

TEST(LineReader, ItDoesNotMatterHowTheBytesAreCut) {
    const std::string text = "a\r\n\nbcdefg\nhij";
    for (const std::string& bytes : {text, gzip(text), gzip("a\n\nbcd") + gzip("efg\nhij"),
                                     gzip(text) + std::string(9, '\0'), gzip(text) + "\x1f"}) {
        for (std::size_t size = 2; size < bytes.size(); ++size) {
            // A piece lies where the one before it was.
            const auto pieces = [&, at = std::size_t{0}, piece = std::string()]() mutable {
                piece = bytes.substr(std::min(at, bytes.size()), size);
                at += size;
                return std::string_view(piece);
            };
            LineReader reader(pieces, "x.log");
            Lines lines;
            while (const auto line = reader.next()) lines.emplace_back(line->text);
            EXPECT_EQ(lines, (Lines{"a", "", "bcdefg", "hij"})) << size;
        }
    }
}

TEST(LineReader, RefusesDamagedGzip) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += std::to_string(i * 7919) + "\n";
    const std::string packed = gzip(text);
    const std::string cut = packed.substr(0, packed.size() / 2);
    EXPECT_EQ(error_of([&] { lines_of(cut); }),
              "x.log: byte " + std::to_string(cut.size()) + ": the compressed data end early");
    std::string wrong_sum = packed;
    wrong_sum[packed.size() - 6] = static_cast<char>(wrong_sum[packed.size() - 6] ^ 1);
    EXPECT_NE(error_of([&] { lines_of(wrong_sum); }).find("damaged compressed data"),
              std::string::npos);
    EXPECT_NE(error_of([] { lines_of("\x1f\x8bnonsense"); }).find("x.log: byte "),
              std::string::npos);
}

TEST(LineReader, RefusesToUnpackWithoutEnd) {
    const std::string packed = gzip(std::string(std::size_t{1} << 20U, '\n'));
    const LineLimits limits{.max_total_bytes = 500'000};
    EXPECT_EQ(error_of([&] { lines_of(packed, limits); }),
              "x.log: unpacks to more than the 500000 bytes that are read at most");
}

}  // namespace
}  // namespace quadcut::io
