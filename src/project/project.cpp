// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "io/file.hpp"
#include "io/room_name.hpp"
#include "io/updates.hpp"
#include "project/begun_with.hpp"
#include "project/growing.hpp"
#include "project/project_file.hpp"
#include "quadcut/base/error.hpp"

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

Point middle_of(Cell cell, double resolution_m) {
    return {(cell.x + 0.5) * resolution_m, (cell.y + 0.5) * resolution_m};
}

}  // namespace

struct Project::Impl {
    enum class Home : std::uint8_t { memory, file, file_to_read };

    Impl(project::ProjectFile project_file, Home project_home, const RunOptions& run)
        : home(project_home),
          file(std::move(project_file)),
          follower(file.follower(run)),
          progress(file.progress()),
          history(file.edits()) {
        updates->append(file.update_lines());
        num_saved = updates->size();
        sum_up();
    }

    /// Changes wait for each other, in the order in which they were begun.
    class Turn {
    public:
        explicit Turn(Impl& impl) : Turn(impl, std::unique_lock(impl.mutex)) {}
        Turn(Impl& impl, std::unique_lock<std::mutex> lock) : impl_(impl) {
            const std::uint64_t own = impl.next_turn++;
            impl.is_over.wait(lock, [&] { return impl.turn == own; });
        }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;
        ~Turn() {
            {
                const std::lock_guard lock(impl_.mutex);
                ++impl_.turn;
            }
            impl_.is_over.notify_all();
        }

    private:
        Impl& impl_;
    };

    template <typename Make>
    auto change(const Make& make) {
        if (home == Home::file_to_read) throw std::logic_error("a project that is only read");
        const Turn own(*this);
        return make();
    }

    // What follows is called by who has the turn.

    FollowUpdate add(const Scan& scan) {
        const FollowUpdate update = follower.add_scan(scan);
        way->append({{scan.world_from_sensor.x, scan.world_from_sensor.y}});
        return take(update);
    }

    FollowUpdate take(FollowUpdate update) {
        update.events.insert(update.events.begin(), refined.begin(), refined.end());
        refined.clear();
        updates->append(io::to_json_line(update));
        set_progress({progress.position, false});
        tell(update);
        return update;
    }

    void set_progress(project::Progress now) {
        const std::lock_guard lock(mutex);
        progress = std::move(now);
    }

    /// Lets all know of a change that was made.
    void tell(const FollowUpdate& update) {
        for (const LifeEvent& event : update.events) events.emplace_back(update.scan, event);
        bool is_asked_for = false;
        {
            const std::lock_guard lock(mutex);
            sum_up();
            is_asked_for = is_wanted;
        }
        if (is_asked_for) publish();
    }

    void sum_up() {
        state.revision = follower.state().revision;
        state.num_scans = follower.num_scans();
        state.num_rooms = follower.num_rooms();
    }

    std::shared_ptr<const Snapshot> publish() {
        Snapshot::Story story{
            [lines = updates, count = updates->size()] { return lines->between(0, count); },
            [points = way, count = way->size()] { return points->between(0, count); }};
        auto made = std::make_shared<const Snapshot>(follower, state.revision, std::move(story));
        const std::lock_guard lock(mutex);
        is_wanted = false;
        return latest = std::move(made);
    }

    void save() {
        file.save(follower,
                  {updates->between(num_saved, updates->size()), std::exchange(events, {})},
                  progress);
        num_saved = updates->size();
        saved_at = std::chrono::steady_clock::now();
    }

    void save_in_time() {
        const bool is_due = std::chrono::steady_clock::now() - saved_at > kSaveAfter;
        if (home == Home::file && is_due) save();
    }

    EditRecord reverse(EditRecord record, EditState becomes);
    void note(const EditRecord& record);

    const Home home;
    // Of who has the turn.
    project::ProjectFile file;
    Follower follower;
    /// What refining did since the last update.
    std::vector<LifeEvent> refined;
    std::vector<std::pair<std::size_t, LifeEvent>> events;
    std::size_t num_saved = 0;
    std::chrono::steady_clock::time_point saved_at = std::chrono::steady_clock::now();
    const std::shared_ptr<project::Growing<std::string>> updates =
        std::make_shared<project::Growing<std::string>>();
    const std::shared_ptr<project::Growing<std::vector<Point>>> way =
        std::make_shared<project::Growing<std::vector<Point>>>();

    // Written by who has the turn and the mutex, read by who has one of them.
    std::mutex mutex;
    std::condition_variable is_over;
    std::uint64_t next_turn = 0;
    std::uint64_t turn = 0;
    bool is_wanted = false;
    std::shared_ptr<const Snapshot> latest;
    ProjectState state;
    project::Progress progress;
    std::vector<EditRecord> history;
};

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
        impl_->tell({});
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

EditRecord Project::edit(const Edit& edit) {
    return impl_->change([&] {
        impl_->file.require_whole();
        EditRecord record{0, impl_->follower.num_scans(), edit, EditState::done};
        Edit& made = record.edit;
        if (made.kind == EditKind::rename) made.name = io::trimmed_room_name(edit.name);
        const Edited edited = impl_->follower.edit(made);
        made.room = edited.inverse.room;
        made.other = edited.inverse.other;
        if (made.kind == EditKind::split) {
            const SplitLine& line = edited.inverse.lines.front();
            made.from = middle_of(line.from, options().resolution_m);
            made.to = middle_of(line.to, options().resolution_m);
        }
        record.number = impl_->file.add(record, edited.inverse);
        impl_->note(record);
        impl_->tell(edited.update);
        return record;
    });
}

EditRecord Project::undo() {
    return impl_->change([&] {
        const std::vector<EditRecord>& all = impl_->history;
        const auto last = std::find_if(all.rbegin(), all.rend(), [](const EditRecord& record) {
            return record.state == EditState::done || record.state == EditState::fixed;
        });
        if (last == all.rend()) throw InputError("there is nothing to undo");
        if (last->state == EditState::fixed) {
            throw InputError("edit " + std::to_string(last->number) +
                             " was made by a version of quadcut that did not keep how to undo it");
        }
        return impl_->reverse(*last, EditState::undone);
    });
}

EditRecord Project::redo() {
    return impl_->change([&] {
        for (const EditRecord& record : impl_->history) {
            if (record.state == EditState::undone) return impl_->reverse(record, EditState::done);
        }
        throw InputError("there is nothing to redo: no edit was undone since the last was made");
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
        const std::uint64_t held = impl_->latest ? impl_->latest->revision() : 0;
        if (impl_->latest && held == impl_->state.revision) return impl_->latest;
        if (impl_->turn == impl_->next_turn) {
            const Impl::Turn own(*impl_, std::move(lock));
            return impl_->publish();
        }
        impl_->is_wanted = true;
        if (impl_->latest && held >= at_least) return impl_->latest;
        impl_->is_over.wait(lock);
    }
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

EditRecord Project::Impl::reverse(EditRecord record, EditState becomes) {
    file.require_whole();
    try {
        const Edited edited = follower.apply(file.inverse_of(record));
        record.state = becomes;
        file.set_state(record, edited.inverse);
        note(record);
        tell(edited.update);
    } catch (const InputError& error) {
        throw InputError("edit " + std::to_string(record.number) + " cannot be " +
                         (becomes == EditState::undone ? "undone" : "made again") +
                         " after what was seen since: " + error.what());
    }
    return record;
}

/// What was undone before a new edit cannot be made again.
void Project::Impl::note(const EditRecord& record) {
    const std::lock_guard lock(mutex);
    const auto same = std::find_if(history.begin(), history.end(), [&](const EditRecord& earlier) {
        return earlier.number == record.number;
    });
    if (same != history.end()) {
        *same = record;
        return;
    }
    for (EditRecord& earlier : history) {
        if (earlier.state == EditState::undone) earlier.state = EditState::dropped;
    }
    history.push_back(record);
}
}  // namespace quadcut
