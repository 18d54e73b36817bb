// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/input.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::io {

/// What is known of a source before its first scan is given.
struct SourceFacts {
    std::string name;                   ///< in messages
    std::size_t num_scans = 0;          ///< that it gives in all
    std::uint64_t content_hash = 0;     ///< of its bytes
    std::uint64_t scans_hash = 0;       ///< also of the poses of all its scans
    std::vector<std::string> warnings;  ///< what a user should know of: one sentence each
};

/// Scans one by one, in the order they were made. What cannot be part of one map is left out.
class ScanSource {
public:
    ScanSource() = default;
    ScanSource(const ScanSource&) = delete;
    ScanSource& operator=(const ScanSource&) = delete;
    virtual ~ScanSource() = default;

    [[nodiscard]] virtual const SourceFacts& facts() const = 0;
    /// The next scan; nothing at the end. Throws InputError when it cannot be read any more.
    [[nodiscard]] virtual std::optional<Scan> next() = 0;
    /// Begins again with the first scan.
    virtual void rewind() = 0;
    /// How many scans were given so far.
    [[nodiscard]] virtual std::size_t num_done() const = 0;
    /// Where the last scan stands, for messages: "line 12".
    [[nodiscard]] virtual std::string place() const = 0;
};

/// Passes over scans until so many are done, or the source ends.
void skip_to(ScanSource& source, std::size_t num_done);

struct ScanSourceOptions {
    /// A file of poses that replace the source's own (see PoseMatch).
    std::optional<std::filesystem::path> poses;
    /// Of the map that the scans are for: scans too far from the others for one map of this
    /// resolution (see find_far_scans) are left out, with a warning.
    double resolution_m = 0.05;
    /// A reading from here on means "no return"; when not given, what the source states or shows.
    std::optional<double> max_range_m = {};
};

/// The scans of a file or pipe, of which no more is kept than 32 bytes a scan while it is looked
/// through, and a bit afterwards (the poses of `options` are kept, too). What a scan means can
/// depend on all of them, so the file is looked through twice before the first is given. Throws
/// InputError when the file or the poses cannot be read, are damaged or hold no scan that can be
/// used; next() does when the file has changed since.
[[nodiscard]] std::unique_ptr<ScanSource> open_scan_source(Input input,
                                                           const ScanSourceOptions& options);

}  // namespace quadcut::io
