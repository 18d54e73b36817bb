// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/door_model.hpp"

#include <numeric>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "quadcut/rooms/fuse.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

/// An opening of 0.9 m between two places of 4 m, more or less, and no furniture.
BorderMeasure opening_with_walls(double walls_m) {
    Narrowing narrowing;
    narrowing.half_width_m = 0.45;
    for (SideOfSaddle* side : {&narrowing.narrower, &narrowing.wider}) {
        *side = {{1.5, 2.0, 2.0}, {10.0, 16.0}, {1.2, 1.4}, 5.0, 16.0, 2.0, 1};
    }
    narrowing.border_ratio = 1.0;
    narrowing.opening.width_m = 0.9;
    narrowing.opening.thin_wall_m = {walls_m, walls_m};
    narrowing.opening.line_of_walls_m = {5.0 * walls_m, 6.0 * walls_m};
    return test::plain_border(narrowing);
}

TEST(DoorModel, WhatCuesAddIsWhatTellsTwoNarrowingsApart) {
    const auto sum = [](const BorderMeasure& border) {
        const auto contributions = door_contributions(border);
        return std::accumulate(contributions.begin(), contributions.end(), 0.0);
    };
    const BorderMeasure door = opening_with_walls(0.5);
    const BorderMeasure none = opening_with_walls(0.0);
    EXPECT_GT(door_log_odds(door), door_log_odds(none));
    EXPECT_NEAR(sum(door) - sum(none), door_log_odds(door) - door_log_odds(none), 1e-6);
}

TEST(DoorModel, CuesHaveNamesOfTheirOwn) {
    std::set<std::string_view> names;
    std::set<std::string_view> texts;
    for (const DoorCue& cue : kDoorCues) {
        names.insert(cue.name);
        texts.insert(cue.text);
    }
    EXPECT_EQ(names.size(), kNumDoorCues);
    EXPECT_EQ(texts.size(), kNumDoorCues);
}

TEST(DoorModel, AGranularityIsOneThreshold) {
    for (const double granularity : {0.0, 0.3, 0.5, 1.0}) {
        EXPECT_NEAR(granularity_from(fuse_threshold(granularity)), granularity, 1e-12);
    }
}

}  // namespace
}  // namespace quadcut
