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
    floor.free = Raster<std::uint8_t>(floor.kept.box(), 0, executor);
    for_each_laid_out(map.states, floor.layout, executor, [&](std::size_t to, std::size_t from) {
        floor.free.values[to] = map.states.values[from] == CellState::free ? 1 : 0;
    });
    return floor;
}

}  // namespace quadcut
