// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/poses.hpp"
#include "quadcut/base/error.hpp"

// The bytes are a trajectory, TUM or g2o, plain or gzip.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto poses =
            quadcut::io::parse_poses({reinterpret_cast<const char*>(data), size}, "fuzz.txt");
        if (poses.empty()) __builtin_trap();
        for (const quadcut::io::TimedPose& timed : poses) {
            if (!std::isfinite(timed.time_s) || !std::isfinite(timed.pose.x) ||
                !std::isfinite(timed.pose.y) || !std::isfinite(timed.pose.yaw_rad)) {
                __builtin_trap();
            }
        }
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
