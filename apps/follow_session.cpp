// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/follow_session.hpp"

#include <array>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/file.hpp"
#include "io/option_text.hpp"
#include "io/updates.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// With the longest update and the time of a save less than a second.
constexpr std::chrono::milliseconds kSaveAfter{500};

/// A project goes on with the options that it has.
void require_same(const std::filesystem::path& path, FollowOptions project, FollowOptions given) {
    const std::string name = io::display_name(path);
    const std::vector<OptionField> had = option_fields(project);
    const std::vector<OptionField> has = option_fields(given);
    for (std::size_t i = 0; i < had.size(); ++i) {
        const std::string before = io::option_text(had[i]);
        const std::string now = io::option_text(has[i]);
        if (had[i].decides != Decides::result || before == now) continue;
        std::string what = name;
        what.append(": was begun with ").append(had[i].name).append(" = ").append(before);
        throw InputError(what.append(": expected the same for this run, not ").append(now));
    }
}

/// Mostly the folder of the results, which is there when they are.
void make_folder_of(const std::filesystem::path& path) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    if (error) {
        throw InputError(io::display_name(path) +
                         ": its folder cannot be made: " + error.message());
    }
}

std::string_view bytes_of(const double& value, std::array<char, sizeof(double)>& buffer) {
    std::memcpy(buffer.data(), &value, sizeof value);
    return {buffer.data(), buffer.size()};
}

}  // namespace

std::uint64_t hash_of(std::span<const Scan> scans, std::uint64_t seed) {
    std::array<char, sizeof(double)> buffer{};
    for (const Scan& scan : scans) {
        const Pose& pose = scan.world_from_sensor;
        for (const double value : {pose.x, pose.y, pose.yaw_rad}) {
            seed = io::hash_bytes(bytes_of(value, buffer), seed);
        }
    }
    return seed;
}

store::Project open_project(const std::filesystem::path& path, const FollowOptions& options,
                            const store::LogPosition& log, std::size_t num_scans) {
    if (!std::filesystem::exists(path)) {
        make_folder_of(path);
        return store::Project::create(path, options, log);
    }
    store::Project project(path, store::Access::write);
    if (project.position().log_hash != log.log_hash) {
        throw InputError(io::display_name(path) + ": follows another log, " +
                         project.position().log + ", or had other poses: expected the same log");
    }
    require_same(path, project.options(), options);
    if (project.position().num_done > num_scans) {
        throw InputError(io::display_name(path) + ": has followed " +
                         std::to_string(project.position().num_done) + " scans of a log with " +
                         std::to_string(num_scans));
    }
    return project;
}

std::vector<std::string> warnings_of(const store::LogPosition& position) {
    if (position.num_left_out == 0) return {};
    return {"scans left out: " + std::to_string(position.num_left_out) +
            "; the first: " + position.first_left_out};
}

FollowSession::FollowSession(const RunOptions& run, std::span<const Scan> scans,
                             std::span<const std::uint64_t> lines, store::Project project)
    : scans_(scans),
      lines_(lines),
      project_(std::move(project)),
      follower_(project_->follower(run)),
      position_(project_->position()),
      updates_(project_->update_lines()) {}

FollowUpdate FollowSession::add_next() {
    FollowUpdate update;
    try {
        update = follower_.add_scan(next());
        update.events.insert(update.events.begin(), refined_.begin(), refined_.end());
        refined_.clear();
        keep(update);
        last_ = update;
    } catch (const InputError& error) {
        if (position_.num_left_out++ == 0) {
            const std::size_t at = position_.num_done;
            const std::string line =
                at < lines_.size() ? "line " + std::to_string(lines_[at]) + ": " : std::string();
            position_.first_left_out = line + error.what();
        }
    }
    ++position_.num_done;
    if (project_ && std::chrono::steady_clock::now() - saved_at_ > kSaveAfter) save();
    return update;
}

bool FollowSession::refine() {
    const std::optional<FollowUpdate> update = follower_.refine();
    if (update) refined_.insert(refined_.end(), update->events.begin(), update->events.end());
    return update.has_value();
}

void FollowSession::finish() {
    if (position_.is_finished) return;
    FollowUpdate update = follower_.finish();
    update.events.insert(update.events.begin(), refined_.begin(), refined_.end());
    refined_.clear();
    keep(update);
    position_.is_finished = true;
    if (project_) save();
}

void FollowSession::keep(const FollowUpdate& update) {
    const std::string line = io::to_json_line(update);
    updates_ += line;
    if (project_) project_->add(update, line);
}

std::string FollowSession::story() const {
    return std::to_string(last_.num_rooms) + (last_.num_rooms == 1 ? " room" : " rooms");
}

void FollowSession::save() {
    project_->save(follower_, position_);
    saved_at_ = std::chrono::steady_clock::now();
}

}  // namespace quadcut
