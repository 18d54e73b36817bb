// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/open_space.hpp"

#include <vector>

namespace quadcut {
namespace {

/// Cells of one obstacle, grown from `seed` over its 8 neighbours; stops early beyond `max_cells`.
struct Obstacle {
    std::vector<std::size_t> cells;
    bool touches_border = false;
};

}  // namespace

Raster<std::uint8_t> open_space(const Raster<std::uint8_t>& kept, double resolution_m,
                                const OpenSpaceOptions& options) {
    Raster<std::uint8_t> open = kept;
    const auto width = static_cast<std::size_t>(kept.width);
    const auto max_cells =
        static_cast<std::size_t>(options.max_furniture_m2 / (resolution_m * resolution_m));
    std::vector<bool> seen(kept.values.size(), false);
    Obstacle obstacle;
    for (std::size_t seed = 0; seed < kept.values.size(); ++seed) {
        if (kept.values[seed] != 0 || seen[seed]) continue;
        obstacle.cells.assign(1, seed);
        obstacle.touches_border = false;
        seen[seed] = true;
        for (std::size_t i = 0; i < obstacle.cells.size(); ++i) {
            const std::size_t x = obstacle.cells[i] % width;
            const std::size_t y = obstacle.cells[i] / width;
            if (x == 0 || y == 0 || x + 1 == width ||
                y + 1 == static_cast<std::size_t>(kept.height)) {
                obstacle.touches_border = true;
            }
            for (std::size_t ny = y == 0 ? 0 : y - 1;
                 ny <= y + 1 && ny < static_cast<std::size_t>(kept.height); ++ny) {
                for (std::size_t nx = x == 0 ? 0 : x - 1; nx <= x + 1 && nx < width; ++nx) {
                    const std::size_t n = ny * width + nx;
                    if (kept.values[n] != 0 || seen[n]) continue;
                    seen[n] = true;
                    obstacle.cells.push_back(n);
                }
            }
        }
        if (obstacle.touches_border || obstacle.cells.size() >= max_cells) continue;
        for (const std::size_t cell : obstacle.cells) open.values[cell] = 1;
    }
    return open;
}

}  // namespace quadcut
