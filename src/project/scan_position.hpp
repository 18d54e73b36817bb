// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace quadcut {

/// Where a project is in what it gets its scans from: a log, mostly.
struct ScanPosition {
    /// Its name, which is not empty, and what tells it from others.
    std::string source;
    std::uint64_t source_hash = 0;
    /// Scans that are done, those left out included.
    std::size_t num_done = 0;
    std::size_t num_left_out = 0;
    /// Why the first of these was left out.
    std::string first_left_out;
};

/// The scans that were left out, if any: one warning.
[[nodiscard]] std::vector<std::string> warnings_of(const ScanPosition& position);

}  // namespace quadcut
