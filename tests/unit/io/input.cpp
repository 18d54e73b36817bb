// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/input.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/io/pipe.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::Pipe;
using test::ScratchFolder;

/// Bytes that are not the same everywhere.
std::string some_bytes(std::size_t size) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * i >> 5U);
    return bytes;
}

std::string joined(const Pieces& pieces) {
    std::string bytes;
    for (std::string_view piece = pieces(); !piece.empty(); piece = pieces()) bytes += piece;
    EXPECT_TRUE(pieces().empty());
    return bytes;
}

TEST(Input, AFileIsReadAgainAndAgainPieceByPiece) {
    const ScratchFolder folder;
    const std::string bytes = some_bytes(1'000'001);
    Input input(folder.write("a", bytes));
    EXPECT_EQ(input.beginning().bytes, bytes.substr(0, kBeginningBytes));
    const OpenPieces open = std::move(input).open_pieces();
    const Pieces first = open();
    EXPECT_LT(first().size(), bytes.size());
    EXPECT_EQ(joined(open()), bytes);
    EXPECT_EQ(joined(open()), bytes);
    EXPECT_EQ(joined(Input(folder.write("empty", "")).open_pieces()()), "");
}

TEST(Input, WhatComesFromAPipeIsReadAgainToo) {
    const ScratchFolder folder;
    // Nothing, no more than the beginning, what is kept in memory, and what is not.
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}, kBeginningBytes,
                                   std::size_t{1} << 20U, (std::size_t{1} << 22U) + 7}) {
        const std::string bytes = some_bytes(size);
        const Pipe pipe(folder, bytes);
        const OpenPieces open = Input(pipe.path()).open_pieces();
        EXPECT_EQ(joined(open()), bytes) << size;
        EXPECT_EQ(joined(open()), bytes) << size;
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(Input, AFileThatChangesIsRefused) {
    const ScratchFolder folder;
    const auto path = folder.write("a", some_bytes(1'000'000));
    const Pieces pieces = Input(path).open_pieces()();
    EXPECT_FALSE(pieces().empty());
    std::ofstream(path, std::ios::binary | std::ios::app) << "more";
    EXPECT_EQ(error_of([&] { joined(pieces); }),
              path.string() +
                  ": has changed while it was read: expected a file that nobody writes to; read a "
                  "copy of it");
}

TEST(Input, AFileThatIsReplacedIsReadAsItWas) {
    const ScratchFolder folder;
    const std::string bytes = some_bytes(1'000'000);
    const auto path = folder.write("a", bytes);
    const OpenPieces open = Input(path).open_pieces();
    folder.write("a", "another file of that name");
    EXPECT_EQ(joined(open()), bytes);
}

TEST(Input, WhatIsInMemory) {
    Input input({"", "x", "", "bytes"});
    EXPECT_EQ(input.beginning().name, "x");
    EXPECT_EQ(joined(std::move(input).open_pieces()()), "bytes");
    EXPECT_EQ(Input({"", "x", "", "bytes"}).read_all().bytes, "bytes");
}

TEST(ReadInput, ReadsPipes) {
    const ScratchFolder folder;
    const std::string bytes(300'001, 'x');
    const Pipe pipe(folder, bytes);
    const InputFile file = read_input(pipe.path());
    EXPECT_EQ(file.bytes, bytes);
    EXPECT_EQ(file.name, pipe.path().string());
    EXPECT_EQ(file.folder, folder.path());
}

TEST(ReadInput, ChecksTheBeginningBeforeMoreIsRead) {
    const ScratchFolder folder;
    const Pipe pipe(folder, std::string(std::size_t{1} << 24U, 'x'));
    std::vector<std::size_t> seen;
    EXPECT_EQ(error_of([&] {
                  (void)read_input(pipe.path(), [&](const InputFile& beginning) {
                      seen.push_back(beginning.bytes.size());
                      throw InputError(beginning.name + ": no");
                  });
              }),
              pipe.path().string() + ": no");
    EXPECT_EQ(seen, std::vector<std::size_t>{kBeginningBytes});
}

TEST(ReadInput, ChecksAllOfAShortFile) {
    const ScratchFolder folder;
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, kBeginningBytes - 1,
                                   kBeginningBytes, kBeginningBytes + 1}) {
        const std::string bytes(size, 'a');
        std::size_t seen = kBeginningBytes + 1;
        const InputFile file =
            read_input(folder.write("a", bytes),
                       [&](const InputFile& beginning) { seen = beginning.bytes.size(); });
        EXPECT_EQ(seen, std::min(size, kBeginningBytes));
        EXPECT_EQ(file.bytes, bytes);
    }
}

}  // namespace
}  // namespace quadcut::io
