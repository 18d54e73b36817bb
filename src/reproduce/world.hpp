// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::reproduce {

/// Small worlds are for tests and a first look.
enum class Size : std::uint8_t { small, full };

/// Cells of the maps, metres.
inline constexpr double kResolutionM = 0.05;

/// A place that a robot went through: what an experiment runs on.
struct World {
    /// As it stands in tables: "MIT-CSAIL".
    std::string name;
    /// What it is and where it comes from, one line.
    std::string origin;
    bool is_simulated = true;
    std::vector<Scan> scans;
    std::vector<Point> trajectory;
    /// The map of all scans.
    GridMap map;
    /// The true rooms, where they are known, on the cells of `truth_map`.
    GridMap truth_map;
    Raster<std::uint32_t> truth;
    /// Whether cells of no true room are nobody's; else they are what nobody can name, and what is
    /// made of them counts for nothing.
    bool is_void_judged = true;
    /// The cells on which the preset `paper` follows it, metres.
    double paper_cell_m = kResolutionM;

    [[nodiscard]] bool has_truth() const { return !truth.values.empty(); }
};

/// Throws InputError that names the first file that the functions below would miss in `data`.
void check_data(const std::filesystem::path& data);

/// The paper's well-structured workplace (Fig 11), simulated, explored by a simulated robot.
[[nodiscard]] World workplace(std::uint64_t seed);
/// `data`/logs/mit_csail.log; a simulated building of its size without data.
[[nodiscard]] World mit_csail(const std::optional<std::filesystem::path>& data, Size size,
                              std::uint64_t seed);
/// `data`/logs/intel.log with its true rooms; a simulated building without data.
[[nodiscard]] World intel(const std::optional<std::filesystem::path>& data, Size size,
                          std::uint64_t seed);
/// A cluttered laboratory: `data`/logs/mit_csail_dense.log.gz, every scan of a real robot, with the
/// rooms of `data`/real; a simulated building full of furniture without data.
/// All throw InputError when a file of the data is missing, cannot be read, or does not fit.
[[nodiscard]] World laboratory(const std::optional<std::filesystem::path>& data, Size size,
                               std::uint64_t seed);

}  // namespace quadcut::reproduce
