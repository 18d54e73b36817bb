// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "project/project.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// The scans that were left out of what a project follows, if any: one warning.
[[nodiscard]] std::vector<std::string> warnings_of(const store::LogPosition& position);

/// Scans that are followed one by one, from the first on or from where a project was left, which
/// then is saved every half a second.
class FollowSession {
public:
    /// `lines` are those of the scans in their log, or nothing: what a warning names.
    FollowSession(const FollowOptions& options, const RunOptions& run, std::span<const Scan> scans,
                  std::span<const std::uint64_t> lines)
        : scans_(scans), lines_(lines), follower_(options, run) {}
    /// Goes on where the project is. @pre the project is of these scans.
    FollowSession(const RunOptions& run, std::span<const Scan> scans,
                  std::span<const std::uint64_t> lines, store::Project project);

    [[nodiscard]] bool is_done() const { return position_.num_done >= scans_.size(); }
    [[nodiscard]] std::size_t num_done() const { return position_.num_done; }
    [[nodiscard]] const Scan& next() const { return scans_[position_.num_done]; }
    /// Follows the next scan. One that cannot be used is left out and counted: a robot's log goes
    /// on. @pre not is_done().
    FollowUpdate add_next();
    /// Cuts what is left and saves; nothing when that was done before.
    void finish();
    /// While nothing else is to be done; false when there is nothing to refine.
    bool refine();

    /// "12 rooms": what came of it so far.
    [[nodiscard]] std::string story() const;

    [[nodiscard]] const Follower& follower() const { return follower_; }
    /// The lines of updates.jsonl.
    [[nodiscard]] const std::string& updates() const { return updates_; }
    /// The project as a file. @pre there is one, and finish() was called.
    [[nodiscard]] std::string project_bytes() const { return project_->file_bytes(); }
    /// What was left out, if anything.
    [[nodiscard]] std::vector<std::string> warnings() const { return warnings_of(position_); }

private:
    void keep(const FollowUpdate& update);
    void save();

    std::span<const Scan> scans_;
    std::span<const std::uint64_t> lines_;
    std::optional<store::Project> project_;
    Follower follower_;
    store::LogPosition position_;
    std::string updates_;
    FollowUpdate last_;
    /// What refining did since the last scan.
    std::vector<LifeEvent> refined_;
    std::chrono::steady_clock::time_point saved_at_ = std::chrono::steady_clock::now();
};

/// The project of a log, which is made if it is not there. Refused: one of other scans or options.
/// Throws InputError.
[[nodiscard]] store::Project open_project(const std::filesystem::path& path,
                                          const FollowOptions& options,
                                          const store::LogPosition& log, std::size_t num_scans);

/// Tells scans with other ranges or poses apart.
[[nodiscard]] std::uint64_t hash_of(std::span<const Scan> scans, std::uint64_t seed);

}  // namespace quadcut
