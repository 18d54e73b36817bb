// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/cpu_time.hpp"
#include "bench/distance_transform.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

// The time of segment(), with defaults, over that of the exact distance transform.
namespace quadcut {

inline constexpr int kRuns = 15;
inline constexpr int kNumThreads = 2;

struct Timing {
    std::string map;
    std::size_t num_cells = 0;
    double segment_ms = std::numeric_limits<double>::infinity();
    double transform_ms = std::numeric_limits<double>::infinity();
    /// Of all threads together: more than the wall time when two work, and hardly more when others
    /// use the machine.
    double segment_cpu_ms = std::numeric_limits<double>::infinity();
    double transform_cpu_ms = std::numeric_limits<double>::infinity();
    /// Of the fastest run.
    std::vector<std::pair<std::string, double>> stages_ms;

    [[nodiscard]] double ratio() const { return segment_ms / transform_ms; }
    [[nodiscard]] double cpu_ratio() const { return segment_cpu_ms / transform_cpu_ms; }
};

/// The fastest of each; both take turns, so that what else the machine does meets both.
inline Timing time_map(const std::string& name, const GridMap& map) {
    cv::setNumThreads(kNumThreads);
    Timing timing;
    timing.map = name;
    timing.num_cells = map.states.values.size();
    const cv::Mat image = free_image(map);
    const RunOptions run_options{kNumThreads};
    cv::Mat distances;
    for (int run = 0; run < kRuns; ++run) {
        const double start_cpu_ms = cpu_ms();
        timing.transform_ms =
            std::min(timing.transform_ms, distance_transform_ms(image, distances));
        const double between_cpu_ms = cpu_ms();
        timing.transform_cpu_ms = std::min(timing.transform_cpu_ms, between_cpu_ms - start_cpu_ms);
        Segmentation rooms;
        const double elapsed_ms = timed_ms([&] { rooms = segment(map, {}, run_options); });
        timing.segment_cpu_ms = std::min(timing.segment_cpu_ms, cpu_ms() - between_cpu_ms);
        if (elapsed_ms >= timing.segment_ms) continue;
        timing.segment_ms = elapsed_ms;
        timing.stages_ms = std::move(rooms.report.stages_ms);
    }
    return timing;
}

}  // namespace quadcut
