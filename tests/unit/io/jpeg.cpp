// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/jpeg.hpp"

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

/// A grey JPEG of 8 x 8 pixels of 128: one block, whose codes are one bit long.
std::string make_jpeg(std::uint16_t side = 8) {
    const auto big = [](unsigned value) {
        return std::string{static_cast<char>(value >> 8U), static_cast<char>(value)};
    };
    const std::string table = "\1"s + std::string(16, '\0');  // One code of one bit, for 0.
    return "\xFF\xD8\xFF\xDB"s + big(67) + "\0"s + std::string(64, '\1') + "\xFF\xC0"s + big(11) +
           "\x08"s + big(side) + big(side) + "\x01\x01\x11\0"s + "\xFF\xC4"s + big(20) + "\x00"s +
           table + "\xFF\xC4"s + big(20) + "\x10"s + table + "\xFF\xDA"s + big(8) +
           "\x01\x01\0\0\x3F\0"s + "\x3F\xFF\xD9"s;
}

TEST(Jpeg, ReadsGrey) {
    const Parsed grey = parse(make_jpeg());
    EXPECT_EQ(grey.header, (ImageHeader{8, 8, 1, 255}));
    EXPECT_EQ(grey.samples, Samples(64, 128));
    EXPECT_TRUE(grey.warnings.empty());
    EXPECT_EQ(parse(make_jpeg() + "tail").warnings.size(), 1U);
}

TEST(Jpeg, RefusesWhatIsDamaged) {
    const std::string whole = make_jpeg();
    for (std::size_t length = 3; length < whole.size(); ++length) {
        EXPECT_NE(error_of([&] { parse(whole.substr(0, length)); }), "no error") << length;
    }
    EXPECT_EQ(error_of([&] { parse(make_jpeg(60'000)); }),
              "x.img: the image has 60000 x 60000 pixels, more than the 268435456 that are read at "
              "most of a JPEG");
    EXPECT_EQ(error_of([&] {
                  parse(make_jpeg(10'000));
              }).find("x.img: the JPEG's header promises 10000 x 10000 pixels, more than "),
              0U);
}

}  // namespace
}  // namespace quadcut::io
