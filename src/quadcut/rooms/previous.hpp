// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/region_graph.hpp"

namespace quadcut {

/// The rooms of an earlier result (0 = none) of which most is free still; none when of all of them
/// together it is not: then the result is of another place, or of another frame. O(cells log
/// rooms).
/// @pre both rasters cover the same rectangle.
[[nodiscard]] Raster<std::uint16_t> rooms_still_there(Raster<std::uint16_t> earlier,
                                                      const Raster<CellState>& states);

/// Cuts pieces (labels 1 .. num_pieces) where rooms of an earlier result met in them, so that a
/// border can stay where it was; returns how many there are now. New floor in such a piece goes
/// with the earlier room that is nearest inside of the piece. O(cells).
/// @pre both rasters cover the same rectangle; 0 = no earlier room.
[[nodiscard]] std::uint32_t cut_where_rooms_met(Raster<std::uint32_t>& pieces,
                                                std::uint32_t num_pieces,
                                                const Raster<std::uint16_t>& earlier);

/// What an earlier result says about cuts between regions (docs/decisions/0026-hysteresis.md).
class EarlierDecisions {
public:
    /// Says nothing.
    EarlierDecisions() = default;
    /// As cut_where_rooms_met(), whose pieces these are. O(cells).
    EarlierDecisions(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                     const Raster<std::uint16_t>& earlier);

    /// To be added to the log-odds of a cut between two regions: more than 0 where most of what was
    /// known of them then was in two rooms, less where it was in one; the less the more of them is
    /// new, and the more of the border in one room is a wall now. 0 where one of them is new.
    [[nodiscard]] double log_odds(const RegionGraph& regions, std::uint32_t a, std::uint32_t b);
    /// The same, but it never speaks against a cut: for regions finer than rooms.
    [[nodiscard]] EarlierDecisions for_cuts_only() const;
    /// The earlier room of a piece; 0 = none, or nothing is known.
    [[nodiscard]] std::uint16_t room_of(std::uint32_t piece) const {
        return is_empty() ? std::uint16_t{0} : pieces_[piece].room;
    }
    [[nodiscard]] bool is_empty() const { return pieces_.empty(); }

private:
    /// The earlier room of a piece or of most of a region; 0 = none.
    struct Before {
        std::uint16_t room = 0;
        std::size_t num_cells = 0;
        std::size_t num_known = 0;
    };
    /// What was floor of a room and is none now, between two pieces: so many lines of cells.
    struct NewWall {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::size_t num_lines = 0;
    };
    [[nodiscard]] double openness(const RegionGraph& regions, std::uint32_t a,
                                  std::uint32_t b) const;
    [[nodiscard]] const Before& before(const RegionGraph& regions, std::uint32_t region);

    std::vector<Before> pieces_;
    std::vector<NewWall> new_walls_;
    bool is_for_cuts_ = false;
    /// By region, with the number of joins it had seen then.
    std::map<std::uint32_t, std::pair<std::uint32_t, Before>> regions_;
};

}  // namespace quadcut
