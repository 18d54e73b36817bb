// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/layout.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

Raster<std::uint8_t> drawn(const std::vector<std::string>& rows) {
    Raster<std::uint8_t> mask({3, -2}, static_cast<std::int32_t>(rows.front().size()),
                              static_cast<std::int32_t>(rows.size()));
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        const auto width = static_cast<std::size_t>(mask.width);
        mask.values[i] = rows[rows.size() - 1 - i / width][i % width] == '.' ? 1 : 0;
    }
    return mask;
}

TEST(Layout, TurnedMirroredMovedAndPaddedMapsAreLaidOutAlike) {
    const Raster<std::uint8_t> mask = drawn({"#########",  //
                                             "#......##",  //
                                             "#..###.##",  //
                                             "#.####.##",  //
                                             "#########"});
    const Layout layout = standard_layout(mask);
    const auto standard = laid_out<std::uint8_t>(mask, layout, 0);
    EXPECT_EQ(standard.width, 8);
    EXPECT_EQ(standard.height, 5);
    const std::vector<std::vector<std::string>> others{
        {"#########", "##......#", "##.###..#", "##.####.#", "#########"},
        {"#########", "#.####.##", "#..###.##", "#......##", "#########"},
        {"#####", "#...#", "##..#", "###.#", "###.#", "###.#", "#...#", "#####", "#####"},
        {"############", "############", "##......####", "##..###.####", "##.####.####"}};
    for (const auto& rows : others) {
        const Raster<std::uint8_t> other = drawn(rows);
        const auto same = laid_out<std::uint8_t>(other, standard_layout(other), 0);
        EXPECT_EQ(same.values, standard.values) << rows[1];
    }
}

TEST(Layout, WhatIsPutBackIsWhereItWas) {
    const Raster<std::uint8_t> mask = drawn({"##.##", "##..#", "##.##", "##.##"});
    const Layout layout = standard_layout(mask);
    Raster<std::uint8_t> back(mask.origin, mask.width, mask.height);
    put_back(laid_out<std::uint8_t>(mask, layout, 0), layout, back);
    EXPECT_EQ(back.values, mask.values);
}

TEST(Layout, AnEmptyMaskHasAnEmptyBox) {
    const Layout layout = standard_layout(drawn({"##", "##"}));
    EXPECT_TRUE(layout.box.is_empty());
    EXPECT_TRUE(laid_out<std::uint8_t>(drawn({"##"}), layout, 0).values.empty());
}

}  // namespace
}  // namespace quadcut
