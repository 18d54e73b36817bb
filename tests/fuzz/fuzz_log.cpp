// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/carmen.hpp"
#include "io/scan_source.hpp"
#include "quadcut/base/error.hpp"

// The bytes are a CARMEN log, plain or gzip.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const auto log = quadcut::io::parse_carmen_log(bytes, "fuzz.log");
        if (log.scans.size() != log.lines.size()) __builtin_trap();
        const auto source = quadcut::io::open_scan_source(
            quadcut::io::Input({"", "fuzz.log", "", std::string(bytes)}), {});
        // What a reader hands on keeps its promises.
        if (source->facts().num_scans == 0) __builtin_trap();
        while (const std::optional<quadcut::Scan> scan = source->next()) {
            const quadcut::Pose& pose = scan->world_from_sensor;
            const bool is_finite = std::isfinite(pose.x) && std::isfinite(pose.y) &&
                                   std::isfinite(pose.yaw_rad) && std::isfinite(scan->time_s) &&
                                   std::isfinite(scan->first_angle_rad) &&
                                   std::isfinite(scan->angle_step_rad);
            const bool has_range = scan->max_range_m > 0.0 && std::isfinite(scan->max_range_m);
            if (!is_finite || !has_range || scan->ranges_m.size() < 2) __builtin_trap();
            for (const float range : scan->ranges_m) {
                if (!(range >= 0.0F)) __builtin_trap();
            }
        }
        if (source->num_done() != source->facts().num_scans) __builtin_trap();
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
