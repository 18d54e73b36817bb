// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/inflate.hpp"

#include <gtest/gtest.h>

#include "tests/unit/io/gzip.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::gzip;

TEST(Inflate, UnpacksAllOrTheBeginning) {
    const std::string bytes(1'000'000, 'a');
    EXPECT_EQ(unpack_gzip(gzip(bytes), "x.gz", bytes.size()), bytes);
    EXPECT_EQ(unpack_gzip(gzip("a") + gzip("b"), "x.gz", 2), "ab");
    const std::string beginning = unpack_beginning(gzip(bytes));
    EXPECT_FALSE(beginning.empty());
    EXPECT_LT(beginning.size(), bytes.size());
    EXPECT_EQ(unpack_beginning(gzip("abc")), "abc");
    EXPECT_EQ(unpack_beginning("\x1F\x8B damaged"), "");
}

TEST(Inflate, NamesTheFileThatIsDamagedOrTooLarge) {
    const std::string packed = gzip(std::string(1000, 'a'));
    EXPECT_EQ(error_of([&] { (void)unpack_gzip(packed, "x.gz", 999); }),
              "x.gz: unpacks to more than the 999 bytes that are read at most");
    EXPECT_NE(error_of([&] {
                  (void)unpack_gzip(packed.substr(0, 15), "x.gz", 1000);
              }).find("x.gz: byte 15: the compressed data end early"),
              std::string::npos);
}

}  // namespace
}  // namespace quadcut::io
