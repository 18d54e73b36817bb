// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace quadcut::peers {

/// Seconds. CPU: of all threads together; on a machine that others use it tells more than the wall
/// clock does.
struct Duration {
    double wall_s = std::numeric_limits<double>::infinity();
    double cpu_s = std::numeric_limits<double>::infinity();
};

inline double read_s(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// The least of `num_rounds` calls, by either clock.
template <typename Work>
Duration shortest(int num_rounds, const Work& work) {
    Duration least;
    for (int round = 0; round < num_rounds; ++round) {
        const double wall_s = read_s(CLOCK_MONOTONIC);
        const double cpu_s = read_s(CLOCK_PROCESS_CPUTIME_ID);
        work();
        least.cpu_s = std::min(least.cpu_s, read_s(CLOCK_PROCESS_CPUTIME_ID) - cpu_s);
        least.wall_s = std::min(least.wall_s, read_s(CLOCK_MONOTONIC) - wall_s);
    }
    return least;
}

}  // namespace quadcut::peers
