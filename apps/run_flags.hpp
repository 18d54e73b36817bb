// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/arguments.hpp"
#include "apps/progress.hpp"
#include "io/map_server.hpp"
#include "quadcut/follow/options.hpp"

namespace quadcut {

// Flags that several commands share.

[[nodiscard]] Flag resolution_flag();
/// How the greys of a map are read.
[[nodiscard]] std::vector<Flag> grey_flags();
[[nodiscard]] bool has_grey_flag(const Arguments& arguments);
[[nodiscard]] Flag poses_flag();
/// `--set NAME=VALUE`.
[[nodiscard]] Flag set_flag();
/// Whether an option of scans was set.
[[nodiscard]] bool has_scan_setting(const Arguments& arguments);
[[nodiscard]] Flag json_flag();
[[nodiscard]] Flag quiet_flag();

/// Metres a cell, when given. Throws InputError as io::set_option does.
[[nodiscard]] std::optional<double> resolution_of(const Arguments& arguments);
/// --resolution and the flags of grey_flags(). Throws InputError as io::set_option does.
[[nodiscard]] io::MapReadOptions map_read_options_of(const Arguments& arguments);
[[nodiscard]] std::optional<std::filesystem::path> poses_of(const Arguments& arguments);
/// What the run is to show of its progress.
[[nodiscard]] ProgressStyle progress_style_of(const Arguments& arguments);

/// What goes to standard output at the end of a run.
enum class SummaryStyle : std::uint8_t { none, text, json };
[[nodiscard]] SummaryStyle summary_style_of(const Arguments& arguments);

/// The resolution of maps made from scans when none is given.
inline constexpr double kLogResolution = FollowOptions{}.resolution_m;

}  // namespace quadcut
