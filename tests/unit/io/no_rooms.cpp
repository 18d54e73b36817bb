// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/no_rooms.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

GreyTally tally_of(const std::vector<std::pair<std::size_t, std::uint64_t>>& counts) {
    GreyTally tally;
    for (const auto& [grey, count] : counts) tally.counts[grey] = count;
    return tally;
}

TEST(NoRooms, ExchangedColoursAreTheLikeliestCause) {
    MapKeys keys;
    const GreyTally plan = tally_of({{0, 970}, {255, 30}});
    EXPECT_EQ(why_no_rooms(plan, keys),
              "only 3 % of the pixels are free; if black and white are exchanged, --negate makes "
              "97 % free");
    keys.negate = true;
    EXPECT_EQ(why_no_rooms(tally_of({{0, 30}, {255, 970}}), keys),
              "only 3 % of the pixels are free; if black and white are exchanged, negate: 0 in the "
              "YAML makes 97 % free");
    // White walls on a transparent ground.
    GreyTally white = tally_of({{255, 50}});
    white.num_not_opaque = white.num_transparent = 950;
    EXPECT_EQ(why_no_rooms(white, MapKeys{}),
              "only 5 % of the pixels are free; if black and white are exchanged, --negate makes "
              "95 % free");
}

TEST(NoRooms, AllUnknownOrBelowTheThresholds) {
    const MapKeys keys;
    EXPECT_EQ(why_no_rooms(tally_of({{0, 50}, {205, 950}}), keys),
              "no pixel is free: 95 % are unknown, the others occupied; the brightest grey is 205, "
              "which --free-thresh 0.197 would make free");
    EXPECT_EQ(
        why_no_rooms(tally_of({{100, 950}}), keys),
        "no pixel is free: 100 % are unknown, the others occupied; the brightest grey is 100, "
        "which --free-thresh 0.609 would make free");
    GreyTally transparent;
    transparent.num_not_opaque = transparent.num_transparent = 9;
    EXPECT_EQ(why_no_rooms(transparent, keys), "no pixel is free: none is opaque");
    MapKeys trusting = keys;
    trusting.occupied_thresh = 0.0;
    trusting.free_thresh = 0.0;
    EXPECT_EQ(why_no_rooms(tally_of({{200, 950}}), trusting), "no pixel is free: all are occupied");
}

TEST(NoRooms, AMapWithFloorGivesNoReason) {
    EXPECT_EQ(why_no_rooms(tally_of({{0, 50}, {205, 700}, {254, 250}}), MapKeys{}), "");
    EXPECT_EQ(why_no_rooms(GreyTally{}, MapKeys{}), "no pixel is free: none is opaque");
}

}  // namespace
}  // namespace quadcut::io
