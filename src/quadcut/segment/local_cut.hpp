// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// Cells farther than this from a change keep their room (the walks of the door model end there).
inline constexpr double kDecidedReachM = 5.0;

/// A part of a map that is followed: the auxiliary graph of the paper's steps 4 to 6.
struct LocalWindow {
    Raster<CellState> states;
    /// The room that each cell had; 0 = none.
    Raster<std::uint32_t> rooms;
    /// What is cut anew: all that changed, and kDecidedReachM around it.
    Box decided;
    double resolution_m = 0.05;
    /// Rooms that keep their cells, whose states are those of walls.
    std::set<std::uint32_t> locked;
    /// Rooms that are not cut apart.
    std::set<std::uint32_t> merged;
};

/// The region of a cell that stays as it is: in a locked room.
inline constexpr std::uint32_t kNotCut = 0xffffffff;

/// What a room, or a part of it, has outside of a window.
struct Beyond {
    double area_m2 = 0.0;
    double peak_m = 0.0;
    std::size_t num_openings = 0;
};

/// A connected part of a room, seen in the window, that is not cut anew.
struct KeptPart {
    std::uint32_t room = 0;
    Cell cell;
};

/// An opening between two regions: their cells at its widest place.
struct LocalOpening {
    Cell a;
    Cell b;
    float clearance_m = 0.0F;
    /// The rooms when it was found.
    std::uint32_t room_a = 0;
    std::uint32_t room_b = 0;
};

struct LocalCut {
    /// 1 .. num_regions; 0 = none; kNotCut. Those of kept parts are among them.
    Raster<std::uint32_t> regions;
    std::uint32_t num_regions = 0;
    /// The largest clearance in each region, that of what it continues included.
    std::vector<double> peak_m;
    /// The kept parts, and the region that each is in.
    std::vector<KeptPart> kept;
    std::vector<std::uint32_t> region_of_kept;
    /// Those within `decided`.
    std::vector<LocalOpening> openings;
    std::size_t num_nodes = 0;
};

/// Which of the kept parts of one room are connected outside of the window: the number of each
/// part's group, from 0 on, and what each group has out there.
struct BeyondWindow {
    std::vector<std::size_t> group_of_part;
    std::vector<Beyond> groups;
};
using AskBeyond = std::function<BeyondWindow(std::uint32_t room, const std::vector<Cell>& parts,
                                             const Raster<std::uint32_t>& pieces)>;

/// Cuts the window anew by the same steps as segment(), and fuses what comes out with the rooms
/// around, which stay as they are outside of `decided`. O(cells of the window).
[[nodiscard]] LocalCut cut_locally(const LocalWindow& window, const SegmentOptions& options,
                                   const AskBeyond& beyond, const Executor& executor);

}  // namespace quadcut
