// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/components.hpp"

#include <algorithm>
#include <utility>

namespace quadcut {
namespace {

/// A building fills at least this much of the ground around it; less are things inside of one.
constexpr double kMinBuildingShare = 0.05;

Box box_of(const FreeComponents& free) {
    const auto height = static_cast<std::int32_t>(free.parts.row_begin.size() - 1);
    return {free.origin, {free.origin.x + free.parts.width - 1, free.origin.y + height - 1}};
}

}  // namespace

FreeComponents find_free_components(const Raster<CellState>& states, const Executor& executor) {
    FreeComponents free;
    free.origin = states.origin;
    free.parts = connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free ? 1U : 0U; },
        Connectivity::four, executor);
    free.components.resize(free.parts.count);
    const std::size_t num_rows = free.parts.row_begin.size() - 1;
    const auto width = static_cast<std::size_t>(states.width);
    free.parts.for_each_run([&](const CellRun& run, std::size_t first) {
        FreeComponents::Component& component = free.components[run.part - 1];
        const std::uint32_t length = run.end - run.begin;
        const bool is_edge_row = first < width || first >= width * (num_rows - 1);
        const std::uint32_t num_ends =
            (run.begin == 0 ? 1U : 0U) + (run.end == width && width > 1 ? 1U : 0U);
        component.num_cells += length;
        component.num_border_cells += is_edge_row ? length : num_ends;
    });
    return free;
}

std::optional<std::size_t> find_outside(const FreeComponents& free, std::size_t min_cells) {
    const auto width = static_cast<std::size_t>(free.parts.width);
    const std::size_t height = free.parts.row_begin.size() - 1;
    const std::size_t border =
        width < 2 || height < 2 ? width * height : 2 * width + 2 * height - 4;
    std::optional<std::size_t> outside;
    std::size_t num_others = 0;
    for (std::size_t i = 0; i < free.components.size(); ++i) {
        if (2 * std::size_t{free.components[i].num_border_cells} > border) {
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
    const Box box = box_of(free);
    for (const Cell& cell : cells) {
        if (!box.contains(cell)) continue;
        const std::uint32_t part =
            free.parts.part_at(static_cast<std::uint32_t>(cell.x - free.origin.x),
                               static_cast<std::size_t>(cell.y - free.origin.y));
        if (part != 0) found[part - 1] = true;
    }
    return found;
}

Raster<std::uint8_t> mask_of(const FreeComponents& free, const std::vector<bool>& kept,
                             const Executor& executor) {
    auto mask = Raster<std::uint8_t>::unset(box_of(free));
    std::vector<std::uint8_t> values(kept.size() + 1, 0);
    std::copy(kept.begin(), kept.end(), values.begin() + 1);
    free.parts.paint(values, mask, executor);
    return mask;
}

}  // namespace quadcut
