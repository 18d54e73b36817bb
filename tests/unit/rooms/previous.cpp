// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/previous.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/rooms/drawing.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

using Rows = std::vector<std::string>;

Raster<std::uint16_t> drawn_rooms(const Rows& rows) {
    const Raster<std::uint32_t> labels = test::drawn_labels(rows);
    Raster<std::uint16_t> rooms(labels.box());
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        rooms.values[i] = static_cast<std::uint16_t>(labels.values[i]);
    }
    return rooms;
}

TEST(EarlierRooms, PiecesAreCutWhereRoomsMet) {
    Raster<std::uint32_t> pieces = test::drawn_labels({"aaaaabbb",  //
                                                       "aaaaabbb"});
    // Two rooms met in the first piece; in the second one is some new floor.
    const std::uint32_t count = cut_where_rooms_met(pieces, 2,
                                                    drawn_rooms({"dd.eeee.",  //
                                                                 "dd.eee.."}));
    EXPECT_EQ(count, 3U);
    EXPECT_EQ(test::as_drawing(pieces), (Rows{"aaaccbbb",  //
                                              "aaaccbbb"}));
}

TEST(EarlierRooms, NewFloorGoesWithWhatIsNearestInsideOfItsPiece) {
    Raster<std::uint32_t> pieces = test::drawn_labels({"aaaaa",  //
                                                       "bbbba",  //
                                                       "aaaaa"});
    EXPECT_EQ(cut_where_rooms_met(pieces, 2,
                                  drawn_rooms({"d....",  //
                                               ".....",  //
                                               "e...."})),
              3U);
    // Around the corner, not through the other piece.
    EXPECT_EQ(test::as_drawing(pieces), (Rows{"ccccc",  //
                                              "bbbba",  //
                                              "aaaaa"}));
}

TEST(EarlierRooms, WhatIsNoLongerFreeSaysNothing) {
    const auto states = [](const Rows& rows) { return test::drawn_map(rows).states; };
    const Raster<std::uint16_t> rooms = drawn_rooms({"aaaaaaaabbbb"});
    EXPECT_EQ(rooms_still_there(rooms, states({"............"})).values, rooms.values);
    EXPECT_EQ(rooms_still_there(rooms, states({"..........##"})).values,
              drawn_rooms({"aaaaaaaa...."}).values);
    EXPECT_TRUE(rooms_still_there(rooms, states({"  ....  ...#"})).values.empty())
        << "of another frame";
}

struct Floor {
    Raster<std::uint32_t> pieces;
    Raster<float> clearance;
    test::PlainGround plain;
    RegionGraph regions;
    EarlierDecisions earlier;
    Floor(const Rows& drawn, std::uint32_t count, const Rows& rooms, float clearance_m = 0.5F)
        : pieces(test::drawn_labels(drawn)),
          clearance(pieces.box(), clearance_m),
          plain(clearance, 0.05),
          regions(pieces, count, plain.ground()),
          earlier(pieces, count, drawn_rooms(rooms)) {}
};

TEST(EarlierRooms, SpeakForTheCutThatWasThereAndAgainstAnother) {
    Floor floor({"aaaabbbbccccdddd"}, 4, {"xxxxxxxxyyyy...."});
    const double apart = floor.earlier.log_odds(floor.regions, 2, 3);
    EXPECT_GT(apart, 3.0);
    EXPECT_LT(floor.earlier.log_odds(floor.regions, 1, 2), -apart) << "the wall may have gone";
    EXPECT_EQ(floor.earlier.log_odds(floor.regions, 3, 4), 0.0) << "all of it is new";
    EXPECT_EQ(floor.earlier.room_of(4), 0U);
    EXPECT_EQ(floor.earlier.room_of(3), 25U);
    EarlierDecisions none;
    EXPECT_TRUE(none.is_empty());
    EXPECT_EQ(none.log_odds(floor.regions, 1, 2), 0.0);
    EXPECT_EQ(none.room_of(1), 0U);
}

TEST(EarlierRooms, SayLessTheMoreIsNew) {
    Floor known({"aaaabbbb"}, 2, {"xxxxyyyy"});
    Floor partly({"aaaabbbb"}, 2, {"xxxxy..."});
    const double all = known.earlier.log_odds(known.regions, 1, 2);
    const double less = partly.earlier.log_odds(partly.regions, 1, 2);
    EXPECT_GT(less, 0.0);
    EXPECT_LT(less, 0.5 * all);
}

TEST(EarlierRooms, SayNothingWhereAWallHasAppeared) {
    const Rows rooms{"xxxxxxxxx", "xxxxxxxxx", "xxxxxxxxx", "xxxxxxxxx"};
    Floor open({"aaaaabbbb", "aaaaabbbb", "aaaaabbbb", "aaaaabbbb"}, 2, rooms);
    Floor walled({"aaaa.bbbb", "aaaaabbbb", "aaaa.bbbb", "aaaa.bbbb"}, 2, rooms);
    const double before = open.earlier.log_odds(open.regions, 1, 2);
    const double now = walled.earlier.log_odds(walled.regions, 1, 2);
    EXPECT_LT(before, 0.0);
    EXPECT_EQ(now, 0.0);
    // It was there before, and is no change.
    Floor old({"aaaa.bbbb", "aaaaabbbb", "aaaa.bbbb", "aaaa.bbbb"}, 2,
              {"xxxx.xxxx", "xxxxxxxxx", "xxxx.xxxx", "xxxx.xxxx"});
    EXPECT_EQ(old.earlier.log_odds(old.regions, 1, 2), before);
}

TEST(EarlierRooms, SayNothingOfTwoPiecesOfARoomThatOnlyASlitJoins) {
    Floor slit({"aaaabbbb"}, 2, {"xxxxxxxx"}, 0.03F);
    EXPECT_EQ(slit.earlier.log_odds(slit.regions, 1, 2), 0.0);
}

TEST(EarlierRooms, OfARegionItIsTheRoomOfMostOfIt) {
    Floor floor({"aabbbbcccc"}, 3, {"xxyyyyxxxx"});
    EXPECT_GT(floor.earlier.log_odds(floor.regions, 1, 2), 0.0);
    floor.regions.join(2, 1);
    EXPECT_GT(floor.earlier.log_odds(floor.regions, 2, 3), 0.0) << "y has the majority";
    Floor other({"aaaabbcccc"}, 3, {"xxxxyyxxxx"});
    other.regions.join(2, 1);
    EXPECT_LT(other.earlier.log_odds(other.regions, 2, 3), 0.0);
}

}  // namespace
}  // namespace quadcut
