// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/floor.hpp"

#include "quadcut/segment/inside.hpp"

namespace quadcut {

Floor lay_out_floor(const GridMap& map, std::span<const Point> trajectory, double min_component_m2,
                    const Executor& executor) {
    Floor floor;
    const Raster<std::uint8_t> kept = inside(map, trajectory, min_component_m2, executor);
    floor.layout = standard_layout(kept, executor);
    floor.kept = laid_out<std::uint8_t>(kept, floor.layout, 0, executor);
    floor.states = laid_out<CellState>(map.states, floor.layout, CellState::unknown, executor);
    return floor;
}

}  // namespace quadcut
