// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The floor as a round robot of some width sees it: its middle may be in the cells whose clearance
/// is at least its radius. Floor is what has a room; all else is an obstacle.
struct RobotFloor {
    const Raster<std::uint16_t>& labels;
    Raster<float> clearance_m;
    double resolution_m = 0.05;
    float radius_m = 0.0F;

    /// Any cell may be asked.
    [[nodiscard]] bool fits(Cell cell) const {
        return clearance_m.contains(cell) && clearance_m.at(cell) >= radius_m;
    }
};

/// Length of the straight line between the centres of two cells, in cells.
[[nodiscard]] float cells_between(Cell a, Cell b);

/// Looks along straight lines, and counts the cells that it reads. Where the clearance is large it
/// leaves out as many cells as that vouches for.
class Sight {
public:
    explicit Sight(const RobotFloor& floor) : floor_(floor) {}

    /// Whether the robot can go straight from one cell to the other: it fits in all cells on the
    /// line, and beside each diagonal step. Both are on the raster.
    [[nodiscard]] bool sees(Cell a, Cell b);
    /// Reads one cell.
    [[nodiscard]] float clearance_at(Cell cell);
    [[nodiscard]] std::size_t num_cells() const { return num_cells_; }

private:
    /// From a cell to a neighbour, where it fits in both.
    [[nodiscard]] bool can_step(Cell a, Cell b);

    const RobotFloor& floor_;
    std::size_t num_cells_ = 0;
};

}  // namespace quadcut
