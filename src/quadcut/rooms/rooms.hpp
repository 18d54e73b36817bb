// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/room.hpp"
#include "quadcut/rooms/options.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

/// What is cut into rooms; rasters of one rectangle from cell (0, 0) on.
struct FloorToCut {
    /// 1 = to be cut. Used up.
    Raster<std::uint8_t> kept;
    /// In the map.
    const Raster<CellState>& states;
    double resolution_m = 0.05;
    /// For a window of a map, where what touches the edge goes on beyond it: says what the pieces
    /// (of RoomsCut) have there.
    std::function<void(const Raster<std::uint32_t>& pieces, RegionGraph& regions)> add_beyond;
    /// Not to be fused into fewer rooms, as far as there are so many at the highest granularity.
    std::size_t least_rooms = 0;
    /// The rooms of an earlier result, which count as evidence; empty: none.
    Raster<std::uint16_t> earlier = {};
};

struct RoomsCut {
    /// Regions of any number; 0 = none.
    Raster<std::uint32_t> rooms;
    /// What they were fused from, 1 .. num_pieces; 0 = none. Of a window only.
    Raster<std::uint32_t> pieces;
    std::uint32_t num_pieces = 0;
    /// By piece: the one that stands for all that the spectral cut joined with it. Of a window
    /// only.
    std::vector<std::uint32_t> joined_pieces;
    /// Among walls, and among all obstacles.
    Raster<float> clearance_m;
    Raster<float> free_clearance_m;
    WallLines lines;
    CutReport report;
};

/// The cut of the preset `rooms`, of a map or of a window: clearance, in which furniture does not
/// count; pieces; pieces are fused unless a door is between them, first as far as at the highest
/// granularity, of whose regions all rooms are unions; there, small regions, slivers and pockets
/// find their room. With `hierarchy`: all levels, too.
/// O(cells + 5 m around each saddle, as often as what lies there changes).
[[nodiscard]] RoomsCut cut_into_rooms(FloorToCut floor, const RoomsOptions& options,
                                      StageClock& clock, const Executor& executor,
                                      Hierarchy* hierarchy = nullptr);

}  // namespace quadcut
