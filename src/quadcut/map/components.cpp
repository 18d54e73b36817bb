// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/components.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/map/connected_parts.hpp"

namespace quadcut {
namespace {

/// A building fills at least this much of the ground around it; less are things inside of one.
constexpr double kMinBuildingShare = 0.05;

}  // namespace

FreeComponents find_free_components(const Raster<CellState>& states) {
    ConnectedParts parts = connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free; },
        [](std::size_t, std::size_t) { return true; });
    FreeComponents free{std::move(parts.labels), {}};
    free.components.resize(parts.count);
    const std::uint32_t* label = free.labels.values.data();
    for (std::int32_t y = 0; y < states.height; ++y) {
        const bool is_edge_row = y == 0 || y == states.height - 1;
        for (std::int32_t x = 0; x < states.width; ++x, ++label) {
            if (*label == 0) continue;
            FreeComponents::Component& component = free.components[*label - 1];
            ++component.num_cells;
            if (is_edge_row || x == 0 || x == states.width - 1) ++component.num_border_cells;
        }
    }
    return free;
}

std::optional<std::size_t> find_outside(const FreeComponents& free, std::size_t min_cells) {
    const auto width = static_cast<std::size_t>(free.labels.width);
    const auto height = static_cast<std::size_t>(free.labels.height);
    const std::size_t border =
        width < 2 || height < 2 ? width * height : 2 * width + 2 * height - 4;
    std::optional<std::size_t> outside;
    std::size_t num_others = 0;
    for (std::size_t i = 0; i < free.components.size(); ++i) {
        if (2 * free.components[i].num_border_cells > border) {
            outside = i;
        } else if (free.components[i].num_cells >= min_cells) {
            num_others += free.components[i].num_cells;
        }
    }
    const bool is_building =
        outside && static_cast<double>(num_others) <
                       kMinBuildingShare * static_cast<double>(free.components[*outside].num_cells);
    return is_building ? std::nullopt : outside;
}

std::vector<bool> components_with(const FreeComponents& free, std::span<const Cell> cells) {
    std::vector<bool> found(free.components.size(), false);
    for (const Cell& cell : cells) {
        const std::uint32_t label = free.labels.contains(cell) ? free.labels.at(cell) : 0;
        if (label != 0) found[label - 1] = true;
    }
    return found;
}

Raster<std::uint8_t> mask_of(const FreeComponents& free, const std::vector<bool>& kept) {
    Raster<std::uint8_t> mask(free.labels.origin, free.labels.width, free.labels.height);
    std::transform(free.labels.values.begin(), free.labels.values.end(), mask.values.begin(),
                   [&](std::uint32_t label) {
                       return label != 0 && kept[label - 1] ? std::uint8_t{1} : std::uint8_t{0};
                   });
    return mask;
}

}  // namespace quadcut
