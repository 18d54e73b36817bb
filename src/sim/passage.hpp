// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/map/raster.hpp"
#include "sim/furniture.hpp"
#include "sim/shape.hpp"

namespace quadcut::sim {

/// The radius of the robot for which ways are kept free.
inline constexpr double kRobotRadius = 0.25;

/// One room's floor without furniture as the centre of a robot may use it.
class Passage {
public:
    /// `window` is the room's extent with a margin; `starts` are points just inside its doors.
    Passage(const Raster<std::uint16_t>& labels, const CellGrid& grid, std::uint16_t room,
            const Rect& window, std::vector<Point> starts);

    /// Whether a robot that comes in by one door gets to all others and to the rest of the room.
    /// What lies inside `footprints` need not be reached, nor what amounts to little.
    [[nodiscard]] bool is_open(const std::vector<Obstacle>& obstacles,
                               const std::vector<Polygon>& footprints) const;

private:
    CellGrid grid_;
    // Where the centre may be when the room is empty; 0 outside of the room.
    Raster<std::uint8_t> open_;
    std::size_t num_open_ = 0;
    std::vector<Point> starts_;
};

}  // namespace quadcut::sim
