// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadcut {

/// An earlier part and a new one, by place, that have floor in common.
struct Meeting {
    std::size_t earlier = 0;
    std::size_t now = 0;
    /// In the same unit as the sizes of parts.
    double shared = 0.0;
};

inline constexpr std::size_t kNoKin = SIZE_MAX;

/// Places of parts among the others, or kNoKin.
struct Kin {
    std::size_t same = kNoKin;
    /// The part that has at least half of this one.
    std::size_t holder = kNoKin;
};

struct Kinship {
    std::vector<Kin> earlier;
    std::vector<Kin> now;
};

/// Who is who, given the sizes of the parts.
///
/// Two parts can be the same when what they share is at least half of one of them. Of those, the
/// pair that shares the most is the same, then the next pair among the others, and so on; of pairs
/// that share as much, the first in the list. So no two parts share more with each other than with
/// the parts they are paired with: of the parts of a room, the one that has most of it stays that
/// room. The largest sum of shared areas would not do: it can take a room away from its largest
/// part for the sake of another pair, and a change at one end of a building could change ids at the
/// other. O(n log n) for n meetings.
/// @pre places are less than the number of sizes.
[[nodiscard]] Kinship match_rooms(std::span<const double> earlier_sizes,
                                  std::span<const double> sizes, std::vector<Meeting> meetings);

}  // namespace quadcut
