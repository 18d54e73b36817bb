// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::test {

/// A map of cells of 0.05 m that is painted in rectangles and wedges, in metres from its lower left
/// corner.
class PaintedFloor {
public:
    PaintedFloor(double width_m, double height_m, CellState ground) {
        map.states = Raster<CellState>({0, 0}, cells(width_m), cells(height_m), ground);
    }

    void paint(const Point& low, const Point& high, CellState state) {
        for (std::int32_t y = cells(low.y); y < cells(high.y); ++y) {
            for (std::int32_t x = cells(low.x); x < cells(high.x); ++x) {
                map.states.at({x, y}) = state;
            }
        }
    }
    /// Walls 0.15 m thick around what is free between the corners.
    void room(const Point& low, const Point& high) {
        constexpr double kWall = 0.15;
        for (std::int32_t y = cells(low.y - kWall); y < cells(high.y + kWall); ++y) {
            for (std::int32_t x = cells(low.x - kWall); x < cells(high.x + kWall); ++x) {
                const bool is_inside = x >= cells(low.x) && x < cells(high.x) &&
                                       y >= cells(low.y) && y < cells(high.y);
                if (is_inside) {
                    map.states.at({x, y}) = CellState::free;
                } else if (map.states.at({x, y}) != CellState::free || is_ground_free) {
                    map.states.at({x, y}) = CellState::occupied;
                }
            }
        }
    }
    void door(const Point& low, const Point& high) { paint(low, high, CellState::free); }
    /// Rays upwards from a point, between two directions (x a metre up), of that length.
    void fan(const Point& from, double first_slope, double last_slope, double length_m) {
        for (std::int32_t y = cells(from.y); y < cells(from.y + length_m); ++y) {
            const double up = (y + 0.5) * map.resolution_m - from.y;
            const std::int32_t end = cells(from.x + last_slope * up);
            for (std::int32_t x = cells(from.x + first_slope * up); x <= end; ++x) {
                map.states.at({x, y}) = CellState::free;
            }
        }
    }

    GridMap map;
    /// Walls are painted over what is free.
    bool is_ground_free = false;

private:
    [[nodiscard]] std::int32_t cells(double length_m) const {
        return static_cast<std::int32_t>(std::lround(length_m / map.resolution_m));
    }
};

/// Three rooms above a corridor and three below, of 4 x 3.8 m, walls and all; (2, 2) to (14.3, 12).
inline PaintedFloor flat() {
    PaintedFloor floor(17.0, 20.0, CellState::unknown);
    for (int k = 0; k < 3; ++k) {
        const double x = 2.15 + 4.05 * k;
        floor.room({x, 2.15}, {x + 3.9, 5.95});
        floor.room({x, 8.25}, {x + 3.9, 12.05});
    }
    floor.room({2.15, 6.1}, {14.15, 8.1});
    for (int k = 0; k < 3; ++k) {
        const double x = 3.6 + 4.05 * k;
        floor.door({x, 5.9}, {x + 0.9, 6.15});
        floor.door({x, 8.05}, {x + 0.9, 8.3});
    }
    return floor;
}

/// Two cells wide cracks in windows of the upper rooms, and what is seen through them.
inline PaintedFloor flat_with_fans() {
    PaintedFloor floor = flat();
    for (int k = 0; k < 5; ++k) floor.fan({3.0 + 2.2 * k, 12.0}, -0.02, 0.18, 7.0);
    return floor;
}

/// The room at a point in metres; 0 = none.
inline std::size_t room_at(const Segmentation& rooms, const GridMap& map, const Point& at) {
    return rooms.labels.at(cell_of({at.x / map.resolution_m, at.y / map.resolution_m}));
}

inline std::vector<Room> seen_as(const Segmentation& rooms, Seen seen) {
    std::vector<Room> result;
    for (const Room& room : rooms.rooms) {
        if (room.seen == seen) result.push_back(room);
    }
    return result;
}

}  // namespace quadcut::test
