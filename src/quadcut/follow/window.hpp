// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "quadcut/follow/followed_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/tile_set.hpp"

namespace quadcut {

/// A part of a map that is followed; rasters of one rectangle. Locked rooms, which keep their
/// cells, and the lines where people cut are walls to what is around them.
struct Window {
    Raster<CellState> states;
    /// The room that each cell had; 0 = none.
    Raster<std::uint32_t> rooms;
    /// What is decided anew.
    Box decided;
    std::set<std::uint32_t> locked;
};

/// The parts of a room outside of a window, by what they are connected with.
struct Outside {
    /// Of each part of the room that is seen in the window.
    std::vector<std::size_t> group_of_part;
    /// Cells out there, by group.
    std::vector<std::size_t> num_cells;
    /// The cells of each; empty when there is one group only.
    std::vector<TileSet> groups;
    /// That were looked at to find them.
    std::size_t cells_read = 0;
};

/// A connected part of a room, seen in the window, that is not decided anew.
struct KeptPart {
    std::uint32_t room = 0;
    Cell cell;
    /// Of the room's parts outside.
    std::size_t group = 0;
    std::uint32_t region = 0;
};

/// The region of a cell that stays as it is: in a locked room.
inline constexpr std::uint32_t kNotCut = 0xffffffff;

/// What a window was cut into.
struct WindowCut {
    /// 1 .. num_regions; 0 = none; kNotCut. Those of kept parts are among them.
    Raster<std::uint32_t> regions;
    std::uint32_t num_regions = 0;
    /// The largest clearance in each region, as far as it is in the window; empty: unknown.
    std::vector<double> peak_m;
    std::vector<KeptPart> kept;
    /// Of the rooms of kept parts.
    std::map<std::uint32_t, Outside> outside;
    /// Those within `decided`.
    std::vector<RoomOpening> openings;
    /// Of the window, where doors can be measured as it lies; empty: something in it was not cut.
    Box all_cut;
    /// The size of the graph that was cut.
    std::size_t num_nodes = 0;
    /// In the window and, to see what is connected, outside.
    std::size_t cells_read = 0;
};

/// What is known in a box.
[[nodiscard]] Window read_window(const FollowedMap& followed, const Box& box, const Box& decided);

/// All that changed and what the door model sees from there, and the rooms that it touches: what is
/// known of them now may be more than when they were cut. Of a large room only what is near.
[[nodiscard]] Box cells_to_decide(const FollowedMap& followed, const Box& changed);

/// Regions that no cell of the robot's way lies in, and that do not go on in a room beyond the
/// window, are none; the others are numbered anew. Nothing is done without a way.
void drop_uncrossed(const std::vector<Cell>& way, WindowCut& cut);

/// The cells of lines where people cut belong to the room beside them.
void fill_split_lines(const FollowedMap& followed, WindowCut& cut);

}  // namespace quadcut
