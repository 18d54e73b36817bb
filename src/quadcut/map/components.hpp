// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The connected parts (4 neighbours) of the free space. There may be as many as half the cells.
struct FreeComponents {
    struct Component {
        std::uint32_t num_cells = 0;
        std::uint32_t num_border_cells = 0;  ///< of these, on the border of the raster
    };

    ConnectedParts parts;               ///< part p is component p - 1
    std::vector<Component> components;  ///< in the order of their first cell, row by row
    Cell origin;                        ///< of the raster
};

/// Runs of free cells joined row by row (union-find). O(cells).
[[nodiscard]] FreeComponents find_free_components(const Raster<CellState>& states,
                                                  const Executor& executor = {});

/// Index of the component that covers more than half of the raster's border, if there is one and
/// the others together have at least a twentieth of its cells: the ground around a building.
/// Otherwise it is the building itself, in a map with leaky walls or a tight frame. Components of
/// fewer than `min_cells` do not count as something else. O(components).
[[nodiscard]] std::optional<std::size_t> find_outside(const FreeComponents& free,
                                                      std::size_t min_cells);

/// For each component, whether it holds one of the cells; cells outside are ignored.
[[nodiscard]] std::vector<bool> components_with(const FreeComponents& free,
                                                std::span<const Cell> cells);

/// 1 in the cells of the components that are `kept`. @pre kept.size() == components.size().
[[nodiscard]] Raster<std::uint8_t> mask_of(const FreeComponents& free,
                                           const std::vector<bool>& kept,
                                           const Executor& executor = {});

}  // namespace quadcut
