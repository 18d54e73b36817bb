// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>

#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Where two regions meet at their widest: the pair of touching cells, one in each region, whose
/// smaller clearance is the largest of the common border.
struct Saddle {
    Cell a;
    Cell b;
    float clearance_m = 0.0F;
    /// Pairs of touching cells of the whole border.
    std::size_t num_contacts = 0;
    /// Of these, in a gap of a wall's line; decimetres of wall at its ends, summed.
    std::size_t num_in_line = 0;
    std::size_t less_wall_dm = 0;
    std::size_t more_wall_dm = 0;
};

/// A unit vector in the raster's axes.
struct Direction {
    double x = 1.0;
    double y = 0.0;
};

/// The opening at a saddle, and the walls around it. All zero without obstacles on both sides.
struct Opening {
    bool has_jambs = false;
    /// From the first jamb to the second; without jambs, along the border at the saddle.
    Direction along;
    /// The obstacle cells on both sides of the opening.
    std::array<Cell, 2> jambs{};
    double width_m = 0.0;
    /// Behind each jamb, in line with the opening: length of thin wall, with free space within
    /// 0.4 m on both faces; at most 0.6 m. Smaller one first.
    std::array<double, 2> thin_wall_m{};
    /// For each face of the opening: length of wall flush with it, at the jamb with less of it; at
    /// most 0.6 m. Smaller one first.
    std::array<double, 2> flush_wall_m{};
    /// In line with the opening, up to 6 m behind each jamb: metres of wall surface, also beyond
    /// gaps. Smaller one first.
    std::array<double, 2> line_of_walls_m{};
    /// How far the free space reaches out sideways beyond the jambs, as the mean of the first metre
    /// on that side of the opening: 0 where side walls go on from the jambs; at most 1.5 m. By
    /// side, the one with the larger minimum first; then by jamb, smaller one first.
    std::array<std::array<double, 2>, 2> widening_m{};
};

/// O(cells within 1.6 opening widths, and within 2 m of the jambs).
[[nodiscard]] Opening measure_opening(const Raster<float>& clearance_m, double resolution_m,
                                      const Saddle& saddle);

}  // namespace quadcut
