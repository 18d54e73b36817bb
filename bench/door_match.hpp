// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "quadcut/base/geometry.hpp"

// Found doors against true ones, both as lines from jamb to jamb.
namespace quadcut {

struct DoorLine {
    Point jamb_1;
    Point jamb_2;
};

/// A found door whose middle is farther from the middle of a true one is another one.
inline constexpr double kNearDoorM = 0.6;
/// The two ends of a deep doorway are no farther apart.
inline constexpr double kSameDoorwayM = 1.5;

struct DoorMatch {
    std::size_t num_found = 0;
    std::size_t num_true = 0;
    std::size_t num_right = 0;

    [[nodiscard]] double precision() const { return share(num_right, num_found); }
    [[nodiscard]] double recall() const { return share(num_right, num_true); }
    [[nodiscard]] double f1() const { return share(2 * num_right, num_found + num_true); }

private:
    static double share(std::size_t part, std::size_t whole) {
        return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
    }
};

/// A found door is right when its middle is within `near_m` of the middle of a true one; each of
/// both sides counts once, the nearest pairs first. O(found * true).
inline DoorMatch match_doors(std::span<const DoorLine> found, std::span<const DoorLine> truth,
                             double near_m = kNearDoorM) {
    const auto middle = [](const DoorLine& door) {
        return Point{0.5 * (door.jamb_1.x + door.jamb_2.x), 0.5 * (door.jamb_1.y + door.jamb_2.y)};
    };
    std::vector<std::tuple<double, std::size_t, std::size_t>> near;
    for (std::size_t f = 0; f < found.size(); ++f) {
        for (std::size_t t = 0; t < truth.size(); ++t) {
            const double away_m = distance(middle(found[f]), middle(truth[t]));
            if (away_m <= near_m) near.emplace_back(away_m, f, t);
        }
    }
    std::sort(near.begin(), near.end());
    std::vector<bool> is_found_used(found.size());
    std::vector<bool> is_true_used(truth.size());
    DoorMatch match{found.size(), truth.size(), 0};
    for (const auto& [away_m, f, t] : near) {
        if (is_found_used[f] || is_true_used[t]) continue;
        is_found_used[f] = true;
        is_true_used[t] = true;
        ++match.num_right;
    }
    return match;
}

}  // namespace quadcut
