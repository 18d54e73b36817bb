// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/scan.hpp"
#include "sim/building.hpp"
#include "sim/laser.hpp"

namespace quadcut::sim {

struct RobotOptions {
    std::uint64_t seed = 1;
    LaserOptions laser;
    /// Sweeps a second; key scans are some of them.
    double scan_rate_hz = 10.0;
    /// A scan is kept after so much way or turn, whichever comes first. Zero keeps all.
    double key_distance_m = 0.25;
    double key_turn_rad = 15.0 * 3.14159265358979323846 / 180.0;
    double speed_mps = 0.5;
    double turn_rate_radps = 1.0;
    double radius_m = 0.22;
    /// The robot is content with what it has seen from this near.
    double survey_range_m = 5.0;
    /// Whether it goes on until it has looked into every corner, or only to where it can stand.
    enum class Survey { corners, floor };
    Survey survey = Survey::corners;
    /// Standard deviations of the reported poses about the true ones, and how much of one scan's
    /// error stays in the next: 0 white, 0.9 drifting over some ten scans.
    double pose_noise_m = 0.01;
    double pose_noise_rad = 0.2 * 3.14159265358979323846 / 180.0;
    double pose_correlation = 0.9;
};

/// A key scan: with the pose that a SLAM system would report, and the true pose beside it.
struct KeyScan {
    Scan scan;
    Pose true_pose;
};

struct Exploration {
    std::vector<Scan> scans;
    std::vector<Pose> true_poses;
};

/// A robot that drives to the nearest place it has not seen from near, until there is none that it
/// can get to. It keeps its radius clear of everything that is not free.
class Explorer {
public:
    /// Throws std::logic_error when the robot does not fit at `start`.
    Explorer(const GridMap& world, const Pose& start, const RobotOptions& options);
    /// The same, but what is not 0 in `passed_by`, on the cells of `world`, it need not see.
    Explorer(const GridMap& world, const Pose& start, const RobotOptions& options,
             Raster<std::uint8_t> passed_by);
    ~Explorer();
    Explorer(Explorer&&) noexcept;
    Explorer& operator=(Explorer&&) noexcept;

    /// Drives on to the next key scan; nothing when all has been seen. About 1 ms.
    std::optional<KeyScan> next();

private:
    class Drive;
    std::unique_ptr<Drive> drive_;
};

/// The middle of the widest place of what is open (1), on the cells of a map.
[[nodiscard]] Pose widest_place(const Raster<std::uint8_t>& open, const GridMap& map);

/// Where a robot starts in a building: in its first corridor (or room), as far from all obstacles
/// as can be.
[[nodiscard]] Pose start_pose(const Building& building);

/// All key scans of an exploration.
[[nodiscard]] Exploration explore(const GridMap& world, const Pose& start,
                                  const RobotOptions& options);

}  // namespace quadcut::sim
