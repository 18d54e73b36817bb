// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/options.hpp"
#include "quadcut/rooms/rooms.hpp"
#include "quadcut/segment/inside.hpp"

namespace quadcut {

/// What the rooms of a map are fused from, on the cells of the map; 0 = none.
struct CandidatePieces {
    Raster<std::uint32_t> finest;
    /// After the spectral cut, which joins some of them.
    Raster<std::uint32_t> joined;
};

/// As segment() has them before it fuses, without a trajectory. O(cells).
inline CandidatePieces candidate_pieces(const GridMap& map, const RoomsOptions& options) {
    const Raster<std::uint8_t> kept = inside(map, {}, options.min_component_m2);
    const Layout layout = standard_layout(kept);
    const auto states = laid_out<CellState>(map.states, layout, CellState::unknown);
    StageClock clock;
    // Of a window all pieces are kept; nothing is beyond this one.
    const RoomsCut cut =
        cut_into_rooms({laid_out<std::uint8_t>(kept, layout, 0), states, map.resolution_m,
                        [](const Raster<std::uint32_t>&, RegionGraph&) {}},
                       options, clock, Executor{});
    CandidatePieces pieces;
    pieces.finest = Raster<std::uint32_t>(map.states.box());
    put_back(cut.pieces, layout, pieces.finest);
    pieces.joined = pieces.finest;
    for (std::uint32_t& piece : pieces.joined.values) piece = cut.joined_pieces[piece];
    return pieces;
}

}  // namespace quadcut
