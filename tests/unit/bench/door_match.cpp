// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/door_match.hpp"

#include <gtest/gtest.h>

namespace quadcut {
namespace {

/// A door of one metre whose middle is there.
DoorLine door_at(double x, double y) { return {{x - 0.5, y}, {x + 0.5, y}}; }

TEST(DoorMatch, GoesByTheMiddles) {
    const std::vector<DoorLine> truth{door_at(0.0, 0.0), door_at(5.0, 0.0)};
    // The first is twice as wide, the second just too far away.
    const std::vector<DoorLine> found{{{0.1, -1.0}, {0.1, 1.0}}, door_at(5.0, 0.7)};
    const DoorMatch match = match_doors(found, truth);
    EXPECT_EQ(match.num_right, 1U);
    EXPECT_EQ(match_doors(found, truth, kSameDoorwayM).num_right, 2U);
}

TEST(DoorMatch, CountsEachDoorOnceAndTheNearestFirst) {
    // The found door in the middle is nearer to the right one; the left one is left for the other.
    const std::vector<DoorLine> truth{door_at(0.0, 0.0), door_at(0.8, 0.0)};
    EXPECT_EQ(match_doors(std::vector{door_at(-0.5, 0.0), door_at(0.5, 0.0)}, truth).num_right, 2U);
    const DoorMatch twice =
        match_doors(std::vector{door_at(0.0, 0.1), door_at(0.0, -0.1), door_at(9.0, 9.0)}, truth);
    EXPECT_EQ(twice.num_right, 1U);
    EXPECT_DOUBLE_EQ(twice.precision(), 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(twice.recall(), 1.0 / 2.0);
    EXPECT_DOUBLE_EQ(twice.f1(), 2.0 / 5.0);
}

TEST(DoorMatch, OfNothingIsZero) {
    EXPECT_EQ(match_doors({}, {}).f1(), 0.0);
    EXPECT_EQ(match_doors({}, std::vector{door_at(0.0, 0.0)}).recall(), 0.0);
}

}  // namespace
}  // namespace quadcut
