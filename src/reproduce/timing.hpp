// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

#include "quadcut/base/stage_clock.hpp"

namespace quadcut {

template <typename Work>
double elapsed_ms(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return ms_since(start);
}

/// The least wall time of each work out of so many rounds, in which all take turns: what else the
/// machine does meets them alike.
inline std::vector<double> least_ms(int rounds, const std::vector<std::function<void()>>& works) {
    std::vector<double> least(works.size(), 0.0);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < works.size(); ++i) {
            const double ms = elapsed_ms(works[i]);
            least[i] = round == 0 ? ms : std::min(least[i], ms);
        }
    }
    return least;
}

}  // namespace quadcut
