// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/scan_position.hpp"

#include <array>
#include <cstring>
#include <string_view>

#include "io/file.hpp"

namespace quadcut {
namespace {

std::string_view bytes_of(const double& value, std::array<char, sizeof(double)>& buffer) {
    std::memcpy(buffer.data(), &value, sizeof value);
    return {buffer.data(), buffer.size()};
}

}  // namespace

std::vector<std::string> warnings_of(const ScanPosition& position) {
    if (position.num_left_out == 0) return {};
    return {"scans left out: " + std::to_string(position.num_left_out) +
            "; the first: " + position.first_left_out};
}

std::uint64_t hash_of(std::span<const Scan> scans, std::uint64_t seed) {
    std::array<char, sizeof(double)> buffer{};
    for (const Scan& scan : scans) {
        const Pose& pose = scan.world_from_sensor;
        for (const double value : {pose.x, pose.y, pose.yaw_rad}) {
            seed = io::hash_bytes(bytes_of(value, buffer), seed);
        }
    }
    return seed;
}

}  // namespace quadcut
