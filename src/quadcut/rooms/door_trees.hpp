// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>

namespace quadcut {

/// One question of a tree: is the cue at most the threshold? What follows is the branch of that
/// number, or, from 0 downwards, the leaf of that number; leaves are numbered from below to above.
struct DoorBranch {
    std::uint8_t cue = 0;
    float threshold = 0.0F;
    std::int16_t below = 0;
    std::int16_t above = 0;
};

struct DoorTree {
    std::array<DoorBranch, 5> branches;
    std::array<float, 6> leaves;
};

/// The door model: its log-odds are the bias and one leaf of each tree.
extern const double kDoorBias;
extern const std::array<DoorTree, 300> kDoorTrees;

}  // namespace quadcut
