// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/callouts.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace quadcut::draw {
namespace {

constexpr PageScale kScale{0.0, 200.0, 1.0};
constexpr CalloutPage kPage{300.0, 200.0, 12.0};

double length_of(const Leader& leader) {
    return std::hypot(leader.to.x - leader.from.x, leader.to.y - leader.from.y);
}

TEST(Callouts, StandBesideTheRoomWithALineToIt) {
    const Raster<std::uint16_t> ground({0, 0}, 300, 200);
    const auto callouts =
        place_callouts({{7, "12", {100.0, 100.0}}}, {}, ground, kScale, kPage, Typeface());
    ASSERT_EQ(callouts.size(), 1U);
    EXPECT_EQ(callouts[0].room, 7U);
    EXPECT_EQ(callouts[0].name.text, "12");
    ASSERT_TRUE(callouts[0].leader);
    EXPECT_EQ(callouts[0].leader->from.x, 100.0);
    EXPECT_EQ(callouts[0].leader->from.y, 100.0);
    EXPECT_GT(length_of(*callouts[0].leader), 4.0);
    EXPECT_LT(length_of(*callouts[0].leader), 40.0);
}

TEST(Callouts, LeaveRoomsFreeWherePaperIsNear) {
    Raster<std::uint16_t> ground({0, 0}, 300, 200);
    for (std::int32_t y = 0; y < 200; ++y) {
        for (std::int32_t x = 0; x < 103; ++x) ground.at({x, y}) = 1;
    }
    const Typeface typeface;
    const auto callouts =
        place_callouts({{2, "12", {100.0, 100.0}}}, {}, ground, kScale, kPage, typeface);
    const double left = callouts.at(0).name.anchor.x - typeface.width("12", 12.0) / 2.0;
    EXPECT_GT(left, 103.0);
}

TEST(Callouts, DoNotCoverOtherTextOrEachOther) {
    const Raster<std::uint16_t> ground({0, 0}, 300, 200);
    std::vector<CrampedRoom> rooms;
    for (std::uint32_t room = 1; room <= 12; ++room) {
        rooms.push_back({room, std::to_string(room), {100.0 + room, 100.0}});
    }
    RoomLabel name;
    name.name = {"a long name", 12.0, {105.0, 92.0}};
    const Typeface typeface;
    std::vector<RoomLabel> all = place_callouts(rooms, {name}, ground, kScale, kPage, typeface);
    ASSERT_EQ(all.size(), rooms.size());
    all.push_back(name);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const TextLine& p = all[i].name;
            const TextLine& q = all[j].name;
            const double apart_x =
                std::abs(p.anchor.x - q.anchor.x) -
                (typeface.width(p.text, 12.0) + typeface.width(q.text, 12.0)) / 2;
            const double apart_y = std::abs(p.anchor.y - q.anchor.y) - typeface.cap_height(12.0);
            EXPECT_TRUE(apart_x >= 0.0 || apart_y >= 0.0) << p.text << " on " << q.text;
        }
    }
}

}  // namespace
}  // namespace quadcut::draw
