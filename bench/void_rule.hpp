// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The prediction less the regions that lie, by more than half of their free cells, where the truth
/// is 0: on maps as robots scan them nobody can name what is there.
[[nodiscard]] inline Raster<std::uint32_t> without_void(Raster<std::uint32_t> predicted,
                                                        const Raster<std::uint32_t>& truth,
                                                        const GridMap& map) {
    const auto most = std::max_element(predicted.values.begin(), predicted.values.end());
    std::vector<std::size_t> inside(predicted.values.empty() ? 1 : *most + 1, 0);
    std::vector<std::size_t> in_void = inside;
    for (std::size_t i = 0; i < predicted.values.size(); ++i) {
        if (map.states.values[i] != CellState::free) continue;
        ++inside[predicted.values[i]];
        if (truth.values[i] == 0) ++in_void[predicted.values[i]];
    }
    for (std::uint32_t& region : predicted.values) {
        if (2 * in_void[region] > inside[region]) region = 0;
    }
    return predicted;
}

}  // namespace quadcut
