// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/follower.hpp"

#include <cmath>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/follow/change_log.hpp"
#include "quadcut/follow/check_followed.hpp"
#include "quadcut/follow/cut_again.hpp"
#include "quadcut/follow/cut_submaps.hpp"
#include "quadcut/follow/edits.hpp"
#include "quadcut/follow/followed_result.hpp"
#include "quadcut/follow/seen_rooms.hpp"
#include "quadcut/map/integrate.hpp"

namespace quadcut {
namespace {

/// A room is refined, while there is nothing else to do, when so much of it has come or gone since
/// it was decided as a whole.
constexpr double kMinStale = 0.02;

/// What a batch of writes did to the tree.
void add_counts(const OccupancyMap& map, const MapUpdate& change, FollowUpdate& update) {
    update.nodes_touched = change.nodes_touched;
    update.nodes_rebuilt = change.nodes_rebuilt;
    if (!change.covering) return;
    // Eq. (12): ps
    update.ps = static_cast<double>(map.num_nodes_in(*change.covering)) /
                static_cast<double>(map.num_nodes());
}

}  // namespace

Follower::Follower(const FollowOptions& options, const RunOptions& run)
    : options_(options),
      executor_(run.executor()),
      state_(std::make_unique<FollowedMap>(options.resolution_m)),
      log_(std::make_unique<ChangeLog>()) {}

Follower::Follower(const FollowOptions& options, FollowedMap state, const RunOptions& run)
    : options_(options),
      executor_(run.executor()),
      state_(std::make_unique<FollowedMap>(std::move(state))),
      log_(std::make_unique<ChangeLog>(state_->revision)) {
    if (state_->map.resolution_m() != options.resolution_m) {
        throw InputError("the map has cells of " + std::to_string(state_->map.resolution_m()) +
                         " m: expected " + std::to_string(options.resolution_m));
    }
    check(*state_);
}

Follower::Follower(Follower&& other) noexcept = default;
Follower& Follower::operator=(Follower&& other) noexcept = default;
Follower::~Follower() = default;

/// What all updates have in common; `work` says whether there was one.
template <typename Work>
FollowUpdate Follower::update(const Work& work) {
    FollowUpdate update;
    update.scan = state_->num_scans;
    const auto note = [&] {
        update.changes = tidied(std::move(update.changes));
        update.changes.revision = ++state_->revision;
        if (update.changes.size() > 0) log_->add(update.changes);
    };
    try {
        if (work(update)) note();
        count_events(*state_, update.events);
    } catch (...) {
        // What was written before rooms could not be cut is there.
        if (update.changes.size() > 0) note();
        throw;
    }
    update.changes.revision = state_->revision;
    update.num_leaves = state_->map.num_leaves();
    update.num_rooms = state_->rooms.size();
    return update;
}

FollowUpdate Follower::add_scan(const Scan& scan) {
    return update([&](FollowUpdate& update) {
        const auto start = std::chrono::steady_clock::now();
        require_room_for(*state_, cells_in_reach(state_->map, scan, options_.integrate));
        const MapUpdate change = integrate_scan(state_->map, scan, options_.integrate);
        update.integrate_ms = ms_since(start);
        ++state_->num_scans;
        add_counts(state_->map, change, update);
        note_written(*state_, change.written, update.changes);
        const Pose& pose = scan.world_from_sensor;
        const bool is_entered = note_way(*state_, {pose.x, pose.y}, options_, update.changes);
        count_seen(*state_, change);
        if (is_entered || !change.written.empty()) {
            note_seen(*state_, options_.segment.preset, change.observed);
        }
        if (is_entered || is_cut_due(*state_, options_)) {
            cut_again(*state_, options_, is_entered ? 0.0 : options_.min_patch_m2, executor_,
                      update);
        }
        return true;
    });
}

FollowUpdate Follower::update_cells(const Raster<CellState>& patch) {
    return update([&](FollowUpdate& update) {
        const auto start = std::chrono::steady_clock::now();
        OccupancyMap& map = state_->map;
        if (!patch.values.empty()) {
            require_room_for(*state_, patch.box());
            map.reserve(patch.box().low, patch.box().high);
        }
        for (std::size_t i = 0; i < patch.values.size(); ++i) {
            map.set_state(patch.cell(i), patch.values[i]);
        }
        const MapUpdate change = map.commit();
        update.integrate_ms = ms_since(start);
        add_counts(map, change, update);
        note_written(*state_, change.written, update.changes);
        note_seen(*state_, options_.segment.preset, change.written);
        cut_again(*state_, options_, options_.min_patch_m2, executor_, update);
        return true;
    });
}

FollowUpdate Follower::finish() {
    return update([&](FollowUpdate& update) {
        cut_again(*state_, options_, 0.0, executor_, update);
        return true;
    });
}

std::optional<FollowUpdate> Follower::refine() {
    // The paper's submaps are cut with what is seen with them, and no block by itself.
    if (options_.segment.preset == Preset::paper) return std::nullopt;
    bool is_any = false;
    const FollowUpdate done = update([&](FollowUpdate& update) {
        return is_any = refine_stalest(*state_, options_, kMinStale, executor_, update);
    });
    if (!is_any) return std::nullopt;
    return done;
}

Edited Follower::edit(const Edit& edit) { return apply(change_of(*state_, edit)); }

Edited Follower::apply(const Reversal& reversal) {
    Edited done;
    done.update = update([&](FollowUpdate& update) {
        done.inverse = quadcut::apply(*state_, reversal, options_, executor_, update);
        return true;
    });
    return done;
}

Changes Follower::changes_since(std::uint64_t revision) const {
    Changes changes;
    if (revision >= log_->begin()) {
        changes = log_->since(revision);
    } else {
        changes = everything_in(*state_);
    }
    changes.revision = state_->revision;
    return changes;
}

const OccupancyMap& Follower::map() const { return state_->map; }
std::size_t Follower::num_scans() const { return state_->num_scans; }
std::size_t Follower::num_rooms() const { return state_->rooms.size(); }

RoomId Follower::room_at(const Point& point) const { return quadcut::room_at(*state_, point); }

Segmentation Follower::rooms() const {
    return result_of(*state_, options_.segment.rooms, executor_, options_.zones);
}

std::size_t Follower::bytes() const {
    return state_->map.bytes() + state_->cells.bytes() +
           state_->openings.capacity() * sizeof(RoomOpening);
}

}  // namespace quadcut
