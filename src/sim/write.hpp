// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "quadcut/map/scan.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut::sim {

/// Scans as a CARMEN log: FLASER lines when the beams span 180 degrees in 180, 181, 360 or 361
/// beams, which is all that FLASER can say, else ROBOTLASER1 lines, which state their angles.
/// Ranges in millimetres, poses to a micrometre. "No return" is written as the maximum range.
[[nodiscard]] std::string encode_carmen_log(std::span<const Scan> scans);

/// Poses as TUM lines: time, position, quaternion. @pre as many poses as scans.
[[nodiscard]] std::string encode_true_poses(std::span<const Scan> scans,
                                            std::span<const Pose> poses);

/// Rooms, doors and the options that made them, as JSON in metres of the map frame.
[[nodiscard]] std::string encode_truth(const Building& building, const BuildingOptions& options);

/// Writes into a folder, which is made when missing:
///   map.pgm, map.yaml    what a perfect survey draws, furniture included (map_server)
///   rooms.png            true rooms: 16 bits, 0 = none, otherwise the id
///   truth.json           rooms with kind, doors with jambs, options
/// and, when there are scans,
///   robot.log            CARMEN log with the poses as reported
///   true_poses.tum       the true poses of the scans
/// Each file is written as a whole or not at all. Throws InputError when one cannot be.
void write_simulation(const std::filesystem::path& folder, const Building& building,
                      const BuildingOptions& options, const Exploration& exploration);

}  // namespace quadcut::sim
