// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/open_space.hpp"

#include <algorithm>
#include <vector>

#include "quadcut/map/flood.hpp"

namespace quadcut {

Raster<std::uint8_t> open_space(const Raster<std::uint8_t>& kept, double resolution_m,
                                const OpenSpaceOptions& options) {
    Raster<std::uint8_t> open = kept;
    const double max_cells = options.max_furniture_m2 / (resolution_m * resolution_m);
    std::vector<bool> seen(kept.values.size(), false);
    for (std::size_t seed = 0; seed < kept.values.size(); ++seed) {
        if (kept.values[seed] != 0 || seen[seed]) continue;
        const std::vector<std::size_t> obstacle =
            flood(kept, seed, seen, Connectivity::eight,
                  [&](std::size_t cell) { return kept.values[cell] == 0; });
        const bool is_furniture =
            static_cast<double>(obstacle.size()) < max_cells &&
            std::none_of(obstacle.begin(), obstacle.end(),
                         [&](std::size_t cell) { return is_on_edge(kept, cell); });
        if (!is_furniture) continue;
        for (const std::size_t cell : obstacle) open.values[cell] = 1;
    }
    return open;
}

}  // namespace quadcut
