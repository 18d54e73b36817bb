// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/scan_source.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// The scans of a laser log, in the order of its lines.
struct PosedLog {
    std::string name;  ///< of the log, in messages
    std::vector<Scan> scans;
    /// The line of each.
    std::vector<std::uint64_t> lines;
    std::vector<std::string> warnings;
    std::uint64_t content_hash = 0;
};

/// All scans of a source.
[[nodiscard]] PosedLog parse_posed_log(io::Input log,
                                       const std::optional<std::filesystem::path>& poses,
                                       double resolution_m);

}  // namespace quadcut
