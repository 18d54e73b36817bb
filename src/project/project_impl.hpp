// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// What stands behind a Project.
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "project/growing.hpp"
#include "project/project.hpp"
#include "project/project_file.hpp"
#include "quadcut/follow/change_log.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/follower.hpp"

namespace quadcut {

struct Project::Impl {
    enum class Home : std::uint8_t { memory, file, file_to_read };

    Impl(project::ProjectFile project_file, Home project_home, const RunOptions& run_options)
        : home(project_home),
          run(run_options),
          file(std::move(project_file)),
          follower(file.follower(run)),
          changes(follower.state().revision),
          progress(file.progress()),
          history(file.edits()) {
        updates->append(file.update_lines());
        num_saved = updates->size();
        way->append(file.poses());
        num_poses_saved = way->size();
        saved_revision = follower.state().revision;
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

    FollowUpdate add(const Scan& scan);
    /// Keeps what an update of the follower did, and tells of it.
    FollowUpdate take(FollowUpdate update);
    void set_progress(project::Progress now);
    /// Lets all know of a change that was made.
    void tell(const std::vector<RoomEvent>& told, std::size_t scan);
    void sum_up();
    std::shared_ptr<const Snapshot> publish();
    void save();
    void save_in_time();
    EditRecord reverse(EditRecord record, EditState becomes);
    void note(const EditRecord& record);

    const Home home;
    const RunOptions run;
    // Of who has the turn.
    project::ProjectFile file;
    Follower follower;
    /// What refining did since the last update.
    std::vector<RoomEvent> refined;
    std::vector<std::pair<std::size_t, RoomEvent>> events;
    std::size_t num_saved = 0;
    std::size_t num_poses_saved = 0;
    std::uint64_t saved_revision = 0;
    std::chrono::steady_clock::time_point saved_at = std::chrono::steady_clock::now();
    const std::shared_ptr<project::Growing<std::string>> updates =
        std::make_shared<project::Growing<std::string>>();
    const std::shared_ptr<project::Growing<std::vector<Pose>>> way =
        std::make_shared<project::Growing<std::vector<Pose>>>();

    // Written by who has the turn and the mutex, read by who has one of them.
    std::mutex mutex;
    std::condition_variable is_over;
    std::uint64_t next_turn = 0;
    std::uint64_t turn = 0;
    /// Somebody asks for a snapshot; there is something new to be shown.
    bool is_wanted = false;
    bool is_new = true;
    std::shared_ptr<const Snapshot> latest;
    ProjectState state;
    ChangeLog changes;
    project::Progress progress;
    std::vector<EditRecord> history;
};

}  // namespace quadcut
