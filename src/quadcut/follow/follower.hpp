// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/follow_update.hpp"
#include "quadcut/follow/options.hpp"

namespace quadcut {

enum class CellState : std::uint8_t;
class ChangeLog;
class OccupancyMap;
struct FollowedMap;
template <typename T>
struct Raster;
struct Scan;
struct Segmentation;

/// Keeps a map and its rooms up to date while a robot explores, with work that does not grow with
/// the map: the paper's incremental method. Not for use by two threads at once.
class Follower {
public:
    explicit Follower(const FollowOptions& options = {}, const RunOptions& run = {});
    /// Goes on where state() of a follower with the same options was. Throws InputError when the
    /// state contradicts itself or has another resolution. O(state).
    Follower(const FollowOptions& options, FollowedMap state, const RunOptions& run = {});
    Follower(Follower&& other) noexcept;
    Follower& operator=(Follower&& other) noexcept;
    ~Follower();

    /// Adds a scan; cuts again around what has changed, when it is enough. Throws InputError for a
    /// scan that cannot be used, or so far away that the map would span more than 2^28 cells; the
    /// state is then unchanged. O(cells in sight + cells within 30 m of what has changed + rooms).
    FollowUpdate add_scan(const Scan& scan);
    /// Sets cells of the map: a patch of a grid that a SLAM system publishes, at the cells of
    /// map(). Throws InputError as above.
    FollowUpdate update_cells(const Raster<CellState>& patch);
    /// Cuts around all that has changed, however little.
    FollowUpdate finish();
    /// Decides a part of a room again that has become another since: what idle time is for, in
    /// slices that take as long as an update. Nothing when there is none, and in the preset
    /// `paper`.
    std::optional<FollowUpdate> refine();

    /// Throws InputError, with nothing changed, when a room does not exist or the edit cannot be
    /// made, and says why.
    Edited edit(const Edit& edit);
    /// Takes an edit back, or makes it again, as far as what was seen since allows; throws as
    /// above.
    Edited apply(const Reversal& reversal);

    /// What changed after a revision (Changes::revision, state().revision), for any number of
    /// listeners. O(what changed); before the revision that this Follower began with, all is new.
    [[nodiscard]] Changes changes_since(std::uint64_t revision) const;

    /// All that is known (followed_map.hpp).
    [[nodiscard]] const FollowedMap& state() const { return *state_; }
    [[nodiscard]] const OccupancyMap& map() const;
    [[nodiscard]] std::size_t num_scans() const;
    [[nodiscard]] std::size_t num_rooms() const;
    /// The room at a point of the map frame; 0 = none. O(1).
    [[nodiscard]] RoomId room_at(const Point& point) const;
    /// The rooms on the cells of map().to_grid(), with doors. O(map).
    [[nodiscard]] Segmentation rooms() const;
    /// Bytes held.
    [[nodiscard]] std::size_t bytes() const;

private:
    template <typename Work>
    FollowUpdate update(const Work& work);

    FollowOptions options_;
    Executor executor_;
    std::unique_ptr<FollowedMap> state_;
    std::unique_ptr<ChangeLog> log_;
};

}  // namespace quadcut
