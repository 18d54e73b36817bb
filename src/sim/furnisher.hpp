// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/map/raster.hpp"
#include "sim/furniture.hpp"
#include "sim/piece.hpp"
#include "sim/plan.hpp"

namespace quadcut::sim {

/// Finds places for pieces in one room: on the room's floor, clear of doors and of each other.
class Furnisher {
public:
    Furnisher(const Plan& plan, std::size_t room, const Raster<std::uint16_t>& labels,
              const CellGrid& grid, Random& random);

    /// Keeps a zone of `depth` before each door clear.
    void keep_doors_clear(double depth);
    /// Stands open leaves in the room at a share of its doors.
    void add_leaves(double share);
    /// Against some wall, often in a corner; `gap` is left free before the piece. False when no
    /// place was found.
    bool add_at_wall(const Piece& piece, double gap = 0.0);
    /// With its back to the wall that is farthest from the first door.
    bool add_opposite_door(const Piece& piece);
    /// Against the wall of a door, just beside it.
    bool add_beside_door(const Piece& piece);
    /// In the room at `middle` (part coordinates), turned by `quarters` right angles and a little.
    bool add_free(const Piece& piece, const FloorPart& part, const Point& middle, int quarters,
                  double jitter_rad);
    /// Removes what keeps a robot from getting everywhere.
    void clear_ways();
    /// What is left at a density.
    [[nodiscard]] std::vector<Obstacle> thinned(double density) const;

    [[nodiscard]] const PlanRoom& room() const { return plan_.rooms[room_]; }
    /// The rectangle of floor with the largest area.
    [[nodiscard]] const FloorPart& main_part() const;

private:
    struct Placed {
        std::vector<Obstacle> obstacles;
        Polygon footprint;
        // Kept at densities above this.
        double rank = 0.0;
    };

    [[nodiscard]] bool is_floor(const Point& p) const;
    [[nodiscard]] bool has_floor(const Polygon& footprint) const;
    [[nodiscard]] bool has_back(const Frame& frame, const Rect& footprint) const;
    bool place(const Piece& piece, const Frame& frame, double gap);
    bool add_leaf(const PlanDoor& door, bool hinge_left, double width, double angle);
    bool try_wall(const Piece& piece, const FloorPart& part, int side, double gap);

    const Plan& plan_;
    std::size_t room_;
    const Raster<std::uint16_t>& labels_;
    const CellGrid& grid_;
    Random& random_;
    std::vector<PlanDoor> doors_;
    std::vector<Polygon> kept_clear_;
    std::vector<Obstacle> leaves_;
    std::vector<Placed> placed_;
};

}  // namespace quadcut::sim
