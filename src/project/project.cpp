// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project.hpp"

#include <system_error>
#include <utility>

#include "io/file.hpp"
#include "io/updates.hpp"
#include "project/begun_with.hpp"
#include "project/project_impl.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut {
namespace {

/// With the longest update and the time of a save less than a second.
constexpr std::chrono::milliseconds kSaveAfter{500};

/// Mostly the folder of the results, which is there when they are.
void make_folder_of(const std::filesystem::path& path) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    if (error) {
        throw InputError(io::display_name(path) +
                         ": its folder cannot be made: " + error.message());
    }
}

}  // namespace

Project::Project(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Project::Project(Project&&) noexcept = default;
Project::~Project() = default;

Project Project::create(const std::filesystem::path& path, const FollowOptions& options,
                        const std::optional<ScanPosition>& position, const RunOptions& run) {
    return Project(std::make_unique<Impl>(project::ProjectFile::create(path, options, position),
                                          Impl::Home::file, run));
}

Project Project::open(const std::filesystem::path& path, Access access, const RunOptions& run) {
    const Impl::Home home = access == Access::read ? Impl::Home::file_to_read : Impl::Home::file;
    return Project(std::make_unique<Impl>(project::ProjectFile(path, access), home, run));
}

Project Project::open_or_create(const std::filesystem::path& path, const FollowOptions& options,
                                const ScanPosition& source, const RunOptions& run) {
    if (!std::filesystem::exists(path)) {
        make_folder_of(path);
        return create(path, options, source, run);
    }
    project::ProjectFile file(path, Access::write);
    project::require_begun_with(file, options, source);
    return Project(std::make_unique<Impl>(std::move(file), Impl::Home::file, run));
}

Project Project::in_memory(const FollowOptions& options,
                           const std::optional<ScanPosition>& position, const RunOptions& run) {
    return Project(std::make_unique<Impl>(
        project::ProjectFile::in_memory("a project in memory", options, position),
        Impl::Home::memory, run));
}

FollowUpdate Project::add(const Scan& scan) {
    return impl_->change([&] {
        FollowUpdate update = impl_->add(scan);
        impl_->save_in_time();
        return update;
    });
}

FollowUpdate Project::add(const Raster<CellState>& patch) {
    return impl_->change([&] {
        FollowUpdate update = impl_->take(impl_->follower.update_cells(patch));
        impl_->save_in_time();
        return update;
    });
}

std::optional<FollowUpdate> Project::add_next(const Scan& scan, std::string_view place) {
    return impl_->change([&] {
        std::optional<FollowUpdate> update;
        ScanPosition after = impl_->progress.position.value();
        try {
            update = impl_->add(scan);
        } catch (const InputError& error) {
            const std::string where = place.empty() ? "" : std::string(place) + ": ";
            if (after.num_left_out++ == 0) after.first_left_out = where + error.what();
        }
        ++after.num_done;
        impl_->set_progress({after, false});
        impl_->save_in_time();
        return update;
    });
}

void Project::set_position(const std::optional<ScanPosition>& position) {
    impl_->change([&] { impl_->set_progress({position, impl_->progress.is_finished}); });
}

bool Project::refine() {
    return impl_->change([&] {
        const std::optional<FollowUpdate> update = impl_->follower.refine();
        if (!update) return false;
        impl_->refined.insert(impl_->refined.end(), update->events.begin(), update->events.end());
        impl_->tell({}, update->scan);
        return true;
    });
}

void Project::finish() {
    impl_->change([&] {
        if (impl_->progress.is_finished) return;
        impl_->take(impl_->follower.finish());
        impl_->set_progress({impl_->progress.position, true});
        if (impl_->home == Impl::Home::file) impl_->save();
    });
}

void Project::save() {
    impl_->change([&] {
        if (impl_->home == Impl::Home::file) impl_->save();
    });
}

std::string Project::file_bytes() {
    return impl_->change([&] {
        impl_->save();
        return impl_->file.file_bytes();
    });
}

std::shared_ptr<const Snapshot> Project::snapshot(std::uint64_t at_least) const {
    std::unique_lock lock(impl_->mutex);
    for (;;) {
        if (!impl_->is_new) return impl_->latest;
        if (impl_->turn == impl_->next_turn) {
            const Impl::Turn own(*impl_, std::move(lock));
            return impl_->publish();
        }
        impl_->is_wanted = true;
        if (impl_->latest && impl_->latest->revision() >= at_least) return impl_->latest;
        impl_->is_over.wait(lock);
    }
}

Changes Project::changes_since(std::uint64_t revision) const {
    {
        const std::lock_guard lock(impl_->mutex);
        const std::uint64_t now = impl_->state.revision;
        if (revision >= impl_->changes.begin() && revision <= now) {
            Changes changes = impl_->changes.since(revision);
            changes.revision = now;
            return changes;
        }
    }
    return everything_in(*snapshot()->followed());
}

ProjectState Project::state() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->state;
}

std::vector<EditRecord> Project::history() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->history;
}

std::optional<ScanPosition> Project::position() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->progress.position;
}

const FollowOptions& Project::options() const { return impl_->file.options(); }

FollowUpdate Project::Impl::add(const Scan& scan) {
    const FollowUpdate update = follower.add_scan(scan);
    way->append({{scan.world_from_sensor.x, scan.world_from_sensor.y}});
    return take(update);
}

FollowUpdate Project::Impl::take(FollowUpdate update) {
    update.events.insert(update.events.begin(), refined.begin(), refined.end());
    refined.clear();
    updates->append(io::to_json_line(update));
    set_progress({progress.position, false});
    tell(update.events, update.scan);
    return update;
}

void Project::Impl::set_progress(project::Progress now) {
    const std::lock_guard lock(mutex);
    progress = std::move(now);
}

void Project::Impl::tell(const std::vector<RoomEvent>& told, std::size_t scan) {
    for (const RoomEvent& event : told) events.emplace_back(scan, event);
    // Also of an update that failed halfway.
    Changes made = follower.changes_since(state.revision);
    bool is_asked_for = false;
    {
        const std::lock_guard lock(mutex);
        if (made.size() > 0) changes.add(std::move(made));
        is_new = true;
        sum_up();
        is_asked_for = is_wanted;
    }
    if (is_asked_for) publish();
}

void Project::Impl::sum_up() {
    state.revision = follower.state().revision;
    state.num_scans = follower.num_scans();
    state.num_rooms = follower.num_rooms();
}

std::shared_ptr<const Snapshot> Project::Impl::publish() {
    Snapshot::Story story{
        [lines = updates, count = updates->size()] { return lines->between(0, count); },
        [points = way, count = way->size()] { return points->between(0, count); }};
    auto made = std::make_shared<const Snapshot>(follower.state(), file.options(), run.executor(),
                                                 std::move(story));
    const std::lock_guard lock(mutex);
    is_wanted = is_new = false;
    return latest = std::move(made);
}

void Project::Impl::save() {
    const Changes unsaved = follower.changes_since(saved_revision);
    file.save(
        follower.state(),
        {unsaved.tiles, updates->between(num_saved, updates->size()), std::exchange(events, {})},
        progress);
    saved_revision = unsaved.revision;
    num_saved = updates->size();
    saved_at = std::chrono::steady_clock::now();
}

void Project::Impl::save_in_time() {
    const bool is_due = std::chrono::steady_clock::now() - saved_at > kSaveAfter;
    if (home == Home::file && is_due) save();
}

}  // namespace quadcut
