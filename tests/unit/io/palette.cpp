// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/palette.hpp"

#include <optional>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut::io {
namespace {

TEST(Palette, DistanceIsThatOfOklab) {
    EXPECT_EQ(perceived_distance({10, 20, 30}, {10, 20, 30}), 0.0);
    EXPECT_NEAR(perceived_distance({0, 0, 0}, {255, 255, 255}), 1.0, 1e-6);
    // Red is (0.6280, 0.2249, 0.1258), green (0.8664, -0.2339, 0.1795).
    EXPECT_NEAR(perceived_distance({255, 0, 0}, {0, 255, 0}), 0.5197, 1e-3);
}

TEST(Palette, WritesColoursAsHex) { EXPECT_EQ(to_hex({0, 171, 255}), "#00abff"); }

TEST(Palette, MixesByShare) {
    EXPECT_EQ(mixed({0, 100, 200}, {100, 0, 255}, 0.0), (Rgb{0, 100, 200}));
    EXPECT_EQ(mixed({0, 100, 200}, {100, 0, 255}, 1.0), (Rgb{100, 0, 255}));
    EXPECT_EQ(mixed({0, 100, 200}, {100, 0, 250}, 0.5), (Rgb{50, 50, 225}));
}

TEST(RoomColors, CorridorsAreNeutral) {
    const std::vector<RoomKind> kinds = {RoomKind::corridor, RoomKind::room, RoomKind::corridor};
    const std::vector<RoomPair> pairs = {{1, 2, Closeness::touching}, {1, 3, Closeness::touching}};
    const auto colors = choose_room_colors(kinds, pairs);
    const auto saturation = [](Rgb color) {
        const auto [low, high] = std::minmax({color.red, color.green, color.blue});
        return high - low;
    };
    EXPECT_LT(saturation(colors[0]), 35);
    EXPECT_GT(saturation(colors[1]), 35);
    EXPECT_LT(saturation(colors[2]), 35);
    EXPECT_GE(perceived_distance(colors[0], colors[2]), kClearDistance);
}

TEST(RoomColors, UseTheWholePalette) {
    const std::vector<RoomKind> kinds(40, RoomKind::room);
    const auto colors = choose_room_colors(kinds, {});
    std::set<std::string> names;
    for (const Rgb color : colors) names.insert(to_hex(color));
    EXPECT_EQ(names.size(), 14U);
}

TEST(RoomColors, ThoseThatAreGivenAreKept) {
    const std::vector<RoomKind> kinds(3, RoomKind::room);
    const std::vector<RoomPair> pairs = {
        {1, 2, Closeness::touching}, {1, 3, Closeness::across_wall}, {2, 3, Closeness::touching}};
    const Rgb red{0xFF, 0, 0};
    const auto colors =
        choose_room_colors(kinds, pairs, std::vector<std::optional<Rgb>>{red, std::nullopt, red});
    EXPECT_EQ(colors[0], red);
    EXPECT_EQ(colors[2], red) << "a wall is between them";
    EXPECT_GE(perceived_distance(colors[1], red), kClearDistance);
    const auto alike = choose_room_colors(
        kinds, pairs, std::vector<std::optional<Rgb>>{red, Rgb{0xFE, 0, 0}, std::nullopt});
    EXPECT_EQ(alike[0], red);
    EXPECT_GE(perceived_distance(alike[1], red), kClearDistance) << "they touch";
}

TEST(RoomColors, ThoseThatAreKeptAreNotAllThatIsUsed) {
    const std::vector<RoomKind> kinds(4, RoomKind::room);
    const auto first = choose_room_colors(kinds, {});
    std::vector<std::optional<Rgb>> kept(first.begin(), first.end());
    kept[2].reset();
    const auto second = choose_room_colors(kinds, {}, kept);
    EXPECT_EQ(second[3], first[3]);
    for (const std::size_t other : {0U, 1U, 3U}) EXPECT_NE(second[2], second[other]);
}

TEST(RoomColors, OfNoRoomsAreNone) { EXPECT_TRUE(choose_room_colors({}, {}).empty()); }

TEST(RoomColors, RefuseAPairThatIsNotThere) {
    const std::vector<RoomKind> kinds(2, RoomKind::room);
    const std::vector<RoomPair> pairs = {{1, 3, Closeness::touching}};
    EXPECT_THROW((void)choose_room_colors(kinds, pairs), std::logic_error);
}

}  // namespace
}  // namespace quadcut::io
