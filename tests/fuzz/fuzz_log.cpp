// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/carmen.hpp"
#include "quadcut/base/error.hpp"

// The bytes are a CARMEN log, plain or gzip.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const quadcut::io::LogFile log =
            quadcut::io::parse_carmen_log({reinterpret_cast<const char*>(data), size}, "fuzz.log");
        // What a reader hands on keeps its promises.
        if (log.scans.empty() || log.counts.scans != log.scans.size()) __builtin_trap();
        for (const quadcut::Scan& scan : log.scans) {
            const quadcut::Pose& pose = scan.world_from_sensor;
            const bool is_finite = std::isfinite(pose.x) && std::isfinite(pose.y) &&
                                   std::isfinite(pose.yaw_rad) && std::isfinite(scan.time_s) &&
                                   std::isfinite(scan.first_angle_rad) &&
                                   std::isfinite(scan.angle_step_rad);
            const bool has_range = scan.max_range_m > 0.0 && std::isfinite(scan.max_range_m);
            if (!is_finite || !has_range || scan.ranges_m.size() < 2) __builtin_trap();
            for (const float range : scan.ranges_m) {
                if (!(range >= 0.0F)) __builtin_trap();
            }
        }
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
