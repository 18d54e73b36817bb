// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/room.hpp"

namespace quadcut {

/// Where a region ends, in sides of cells: at the unknown, and at obstacles.
struct RegionBorder {
    std::size_t num_cells = 0;
    std::size_t num_open = 0;
    std::size_t num_closed = 0;
    /// At what is unknown between it and another region; 0 when that was decided.
    std::size_t num_between = 0;

    RegionBorder& operator+=(const RegionBorder& other);
    [[nodiscard]] double open_share() const;
};

/// Of each label; what is beyond the map is unknown. Obstacles are also what has one within two
/// cells, and up to 0.5 m of the unknown before one. Where no more than that lies between two
/// regions, it is a wall if there is much of that in the map, as in plans with grey walls, or else
/// unknown. `labels` are laid out, `states` are not. O(cells).
[[nodiscard]] std::vector<RegionBorder> measure_borders(const Raster<std::uint32_t>& labels,
                                                        const Raster<CellState>& states,
                                                        const Layout& layout, double resolution_m,
                                                        const Executor& executor = {});

/// Where rays went through a crack, a region is a room and a fan beside it. What hangs on the
/// largest part of a region, or the one that goes on beyond the raster, only by what is narrower
/// than `min_width_m` and has `min_area_m2` becomes a region of its own if just one of the two is a
/// fan: ends nearly everywhere in the unknown, and the robot was not there (`way`, laid out as the
/// labels are). O(cells), less where regions hardly end in the unknown.
void split_off_fans(Raster<std::uint32_t>& labels, const Raster<float>& clearance_m,
                    const Raster<CellState>& states, const Layout& layout, double resolution_m,
                    double min_width_m, double min_area_m2, std::span<const Cell> way,
                    const Executor& executor = {});

/// Sets `seen` and `open_border` of rooms 1 .. n of `labels`, whose doors are given by label. A
/// glimpse is what ends mostly in the unknown and leads to one other room at most, or what ends in
/// it in good part and has no door a robot fits through (docs/decisions/0025). None is: where the
/// robot was (`way` as above), the largest room, and anything in a map that shows
/// next to no obstacles. O(cells).
void judge_seen(std::vector<Room>& rooms, const Raster<std::uint32_t>& labels,
                const Raster<CellState>& states, const Layout& layout, double resolution_m,
                std::span<const Door> doors, std::span<const Cell> way,
                const Executor& executor = {});

}  // namespace quadcut
