// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/follower_state.hpp"
#include "quadcut/follow/local_cut.hpp"
#include "quadcut/follow/options.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/map/tile_set.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// The free cells of a tile, bit 8 y + x.
[[nodiscard]] std::uint64_t free_rows(const Tile& tile);

enum class RoomLife : std::uint8_t { born, grown, split, merged, retired };

/// What happened to a room, and why.
struct LifeEvent {
    RoomLife life = RoomLife::born;
    RoomId room{};
    /// split: the room it was a part of. merged: the room it is a part of now.
    RoomId other{};
    std::string reason;
};

/// What one update did: a line of updates.jsonl.
struct FollowUpdate {
    std::size_t scan = 0;
    double integrate_ms = 0.0;
    double segment_ms = 0.0;
    std::size_t num_leaves = 0;
    std::size_t nodes_touched = 0;
    std::size_t nodes_rebuilt = 0;
    /// Eq. (12).
    double ps = 0.0;
    /// Of the largest graph that was cut; 0 when none was.
    std::size_t graph_nodes = 0;
    std::size_t num_rooms = 0;
    double relabelled_m2 = 0.0;
    std::vector<LifeEvent> events;
};

/// What an edit did, and what takes it back.
struct Edited {
    FollowUpdate update;
    Reversal inverse;
};

/// Keeps a map and its rooms up to date while a robot explores, with work that does not grow with
/// the map: the paper's incremental method. Not for use by two threads at once.
class Follower {
public:
    explicit Follower(const FollowOptions& options = {}, const RunOptions& run = {});
    /// Goes on where state_since_save() of a follower with the same options was.
    /// Throws InputError when the state contradicts itself. O(state).
    Follower(const FollowOptions& options, const FollowerState& state, const RunOptions& run = {});

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
    /// slices that take as long as an update. Nothing when there is none.
    std::optional<FollowUpdate> refine();

    /// Throws InputError, with nothing changed, when a room does not exist or the edit cannot be
    /// made, and says why.
    Edited edit(const Edit& edit);
    /// Takes an edit back, or makes it again, as far as what was seen since allows; throws as
    /// above.
    Edited apply(const Reversal& reversal);

    [[nodiscard]] const OccupancyMap& map() const { return map_; }
    [[nodiscard]] std::size_t num_scans() const { return num_scans_; }
    [[nodiscard]] std::size_t num_rooms() const { return rooms_.size(); }
    /// The room at a point of the map frame; 0 = none. O(1).
    [[nodiscard]] RoomId room_at(const Point& point) const;
    /// By id.
    [[nodiscard]] const std::map<std::uint32_t, FollowedRoom>& followed() const { return rooms_; }
    [[nodiscard]] const RoomCells& room_cells() const { return cells_; }
    [[nodiscard]] const std::vector<SplitLine>& split_lines() const { return split_lines_; }
    /// The rooms on the cells of map().to_grid(), with doors. O(map).
    [[nodiscard]] Segmentation rooms() const;
    /// What is to be saved. Of the tiles only those that changed since the last time.
    /// O(changes + rooms).
    [[nodiscard]] FollowerState state_since_save();
    /// Bytes held.
    [[nodiscard]] std::size_t bytes() const;

private:
    /// The parts of a room outside of a window, by what they are connected with.
    struct Outside {
        std::vector<std::size_t> group_of_part;
        /// Cells out there, by group.
        std::vector<std::size_t> num_cells;
        /// The cells of each; empty when there is one group only.
        std::vector<TileSet> groups;
    };
    /// The part of a line that lies in one room and in the walls there; in cells.
    struct RoomStretch {
        std::uint32_t room = 0;
        std::size_t num_cells = 0;
        Cell first;
        Cell last;
    };
    /// What the regions of a window and the rooms there were share.
    struct Overlaps {
        /// Cells by region and room, those outside of the window included.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;
        std::vector<std::size_t> region_cells;
        /// Cells of each room in the window.
        std::map<std::uint32_t, std::size_t> cells_inside;
    };

    [[nodiscard]] bool is_cut_due() const;
    void note_changes(const MapUpdate& update);
    void note_seen(const std::vector<Cell>& tiles);
    [[nodiscard]] std::size_t num_changed_in(const Box& box) const;
    void cut_again(double min_patch_m2, FollowUpdate& update);
    void cut_window(const Box& decided, FollowUpdate& update);
    bool refine_stalest(double min_stale, FollowUpdate& update);
    void note_decided(const Box& decided);
    void cut_seen_submaps(FollowUpdate& update);
    /// Gives the regions of a window their ids, and all that follows from it.
    void take_over(const LocalWindow& window, const LocalCut& cut, FollowUpdate& update);
    [[nodiscard]] Box cells_to_decide(const Box& changed) const;
    [[nodiscard]] LocalWindow read_window(const Box& decided) const;
    BeyondWindow look_beyond(const LocalWindow& window, std::uint32_t room,
                             const std::vector<Cell>& parts, const Raster<std::uint32_t>& pieces);
    [[nodiscard]] Outside groups_outside(const LocalWindow& window, std::uint32_t room,
                                         const std::vector<Cell>& parts,
                                         const Raster<std::uint32_t>& pieces) const;
    [[nodiscard]] std::size_t openings_outside(const LocalWindow& window, std::uint32_t room,
                                               const Outside& outside, std::size_t group) const;
    template <typename Visit>
    void for_each_group(const LocalCut& cut, const Visit& visit) const;
    [[nodiscard]] Overlaps find_overlaps(const LocalWindow& window, const LocalCut& cut) const;
    [[nodiscard]] std::vector<std::uint32_t> name_regions(const Overlaps& overlaps,
                                                          std::uint32_t num_regions,
                                                          FollowUpdate& update);
    void write_window(const LocalWindow& window, const LocalCut& cut,
                      const std::vector<std::uint32_t>& room_of_region, FollowUpdate& update);
    [[nodiscard]] std::vector<Cell> cells_outside(const LocalWindow& window, std::uint32_t room,
                                                  std::size_t group) const;
    void update_rooms(const LocalCut& cut, const Overlaps& overlaps,
                      const std::vector<std::uint32_t>& room_of_region, FollowUpdate& update);
    /// Throws InputError when the map would span too many cells.
    void require_room_for(Box cells) const;
    [[nodiscard]] std::int32_t in_cells(double length_m) const;
    [[nodiscard]] std::uint32_t new_id();
    void sum_up(const MapUpdate& change, FollowUpdate& update) const;
    void take_rooms(const FollowerState& state);
    void take_tile(const FollowedTile& tile);
    [[nodiscard]] std::uint32_t existing(RoomId room) const;
    void add_split_line(const SplitLine& line);
    [[nodiscard]] std::vector<SplitLine> take_split_lines(const Reversal& reversal);
    /// How a room is now, as the beginning of a change.
    [[nodiscard]] Reversal as_is(RoomId room) const;
    [[nodiscard]] Reversal rename(RoomId room, const std::string& name) const;
    [[nodiscard]] Reversal merge(RoomId room, RoomId other) const;
    [[nodiscard]] Reversal split(const Point& from, const Point& to);
    [[nodiscard]] Reversal lock(RoomId room) const;
    [[nodiscard]] Reversal unlock(RoomId room) const;
    void part(const Reversal& reversal, Edited& done);
    void join(const Reversal& reversal, Edited& done);
    [[nodiscard]] std::uint32_t holder_of_part(const Reversal& reversal) const;
    void catch_up(std::uint32_t room, FollowUpdate& update);
    [[nodiscard]] Raster<std::uint8_t> mask_of(std::uint32_t room) const;
    [[nodiscard]] std::uint32_t nearest_room(Cell to) const;
    [[nodiscard]] RoomStretch stretch_of(const Point& from, const Point& to) const;
    void fill_split_lines(const LocalWindow& window, LocalCut& cut) const;

    FollowOptions options_;
    Executor executor_;
    OccupancyMap map_;
    std::size_t num_scans_ = 0;
    RoomCells cells_;
    /// Holds all tiles that were written, in cells.
    Box written_;
    /// Tiles with cells that are free now and were not, or the other way round, and how many.
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> changed_tiles_;
    std::size_t num_changed_ = 0;
    std::map<std::uint32_t, FollowedRoom> rooms_;
    std::vector<LocalOpening> openings_;
    std::vector<SplitLine> split_lines_;
    /// Their cells, by y and x.
    std::set<std::pair<std::int32_t, std::int32_t>> split_cells_;
    /// Of the rooms that go on beyond the window that is being cut.
    std::map<std::uint32_t, Outside> outside_;
    /// The regions of that window that have most of a room.
    std::map<std::uint32_t, std::uint32_t> heirs_;
    std::uint32_t next_id_ = 1;
    std::size_t num_left_over_ = 0;
    /// The number of scans when rooms were last cut.
    std::size_t cut_at_ = 0;
    /// Preset `paper`: submaps seen with something new since the last cut.
    std::set<std::uint32_t> seen_;
};

}  // namespace quadcut
