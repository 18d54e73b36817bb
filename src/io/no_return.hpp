// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace quadcut::io {

/// No laser of the kind these logs hold measures farther indoors: a reading beyond is a code.
inline constexpr double kMaxUsableRange = 80.0;

/// Finds the reading that a laser gives where nothing comes back. Logs seldom state it (81.83,
/// 81.91, 51.06, 50, 30, 8.19 metres are usual), but it shows: of all readings up to
/// kMaxUsableRange it is the farthest, and it is common, whereas true readings get rare towards
/// the farthest one.
class NoReturnFinder {
public:
    NoReturnFinder();

    void add(std::span<const float> ranges_m);

    /// From where on a reading means "no return": the lower end of the highest 2 % of range, where
    /// they hold 0.2 % to 90 % of all readings (and 8 or more), are 4 times as dense as the 10 %
    /// below them, and end beyond 4 m. Up to 0.05 % of readings farther out count as strays.
    /// kMaxUsableRange where the readings show no such value.
    [[nodiscard]] double limit_m() const;

private:
    std::vector<std::uint64_t> counts_;  ///< readings per bin
    std::uint64_t num_readings_ = 0;
};

}  // namespace quadcut::io
