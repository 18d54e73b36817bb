// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// A part of a map that is followed; rasters of one rectangle.
struct LocalWindow {
    Raster<CellState> states;
    /// The room that each cell had; 0 = none.
    Raster<std::uint32_t> rooms;
    /// What is decided anew: far enough from the edge that what lies beyond plays no part.
    Box decided;
    double resolution_m = 0.05;
    /// How the whole map would be laid out to be cut; the box is not used.
    Layout orientation;
    /// Rooms that keep their cells, whose states are those of walls.
    std::set<std::uint32_t> locked;
    /// Of rooms that people made one: parts whose rooms have the same group and touch are one.
    std::map<std::uint32_t, std::uint32_t> merge_groups;
};

/// The region of a cell that stays as it is: in a locked room.
inline constexpr std::uint32_t kNotCut = 0xffffffff;

/// A connected part of a room, seen in the window, that is not decided anew.
struct KeptPart {
    std::uint32_t room = 0;
    Cell cell;
};

/// An opening between two rooms: their cells at its widest place.
struct LocalOpening {
    Cell a;
    Cell b;
    float clearance_m = 0.0F;
    /// Its rooms, in what is saved.
    std::uint32_t room_a = 0;
    std::uint32_t room_b = 0;
};

struct LocalCut {
    /// 1 .. num_regions; 0 = none; kNotCut. Those of kept parts are among them.
    Raster<std::uint32_t> regions;
    std::uint32_t num_regions = 0;
    /// The largest clearance in each region, as far as it is in the window; empty: unknown.
    std::vector<double> peak_m;
    /// The kept parts, and the region that each is in.
    std::vector<KeptPart> kept;
    std::vector<std::uint32_t> region_of_kept;
    /// Those within `decided`.
    std::vector<LocalOpening> openings;
    /// The size of the graph that was cut.
    std::size_t num_nodes = 0;
};

/// Which parts of one room are connected outside of the window: the number of each part's group,
/// from 0 on, and what each group has out there.
struct BeyondWindow {
    std::vector<std::size_t> group_of_part;
    std::vector<Beyond> groups;
};
/// `cells` has a cell of each part, `parts` the part of each cell of the window.
using AskBeyond = std::function<BeyondWindow(std::uint32_t room, const std::vector<Cell>& cells,
                                             const Raster<std::uint32_t>& parts)>;

/// Cuts the window by the same steps as segment() cuts a map, and takes over what comes out within
/// `decided`; outside, rooms stay as they are. A new region that goes on there is the room that is
/// there. O(cells of the window).
[[nodiscard]] LocalCut cut_locally(const LocalWindow& window, const SegmentOptions& options,
                                   const AskBeyond& ask_beyond, const Executor& executor);

}  // namespace quadcut
