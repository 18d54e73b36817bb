// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/stored_result.hpp"
#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// Poses, and what a user should know of them: one sentence each.
struct ResultPoses {
    std::vector<Pose> poses;
    std::vector<std::string> warnings;
};

/// Where the scans were taken of which the map of a result in a folder was made: as its log says,
/// which report.json names, or by the poses of the file that is given; of a map those of the file.
/// Throws InputError, which says what to give, when it is not known, and as open_scan_source().
[[nodiscard]] ResultPoses poses_of_result(const std::filesystem::path& folder,
                                          const io::StoredResult& result, double resolution_m,
                                          const std::optional<std::filesystem::path>& given);

}  // namespace quadcut
