// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/file_batch.hpp"
#include "io/json_writer.hpp"
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

/// The members `rooms` and `doors` of the object that is being written, in metres of the map frame.
void write_rooms_and_doors(io::JsonWriter& json, const Building& building);

/// Rooms, doors and the options that made them, as JSON in metres of the map frame.
[[nodiscard]] std::string encode_truth(const Building& building, const BuildingOptions& options);

/// The files of a simulation with scans.
[[nodiscard]] std::vector<std::string> simulation_files();

/// Adds to a batch, in a folder of it ("simulation/"):
///   map.pgm, map.yaml    what a perfect survey draws, furniture included (map_server)
///   rooms.png            true rooms: 16 bits, 0 = none, otherwise the id
///   truth.json           rooms with kind, doors with jambs, options
/// and, when there are scans,
///   robot.log            CARMEN log with the poses as reported
///   true_poses.tum       the true poses of the scans
/// Errors as FileBatch::add().
void add_simulation(io::FileBatch& batch, const Building& building, const BuildingOptions& options,
                    const Exploration& exploration, const std::string& folder = {});

}  // namespace quadcut::sim
