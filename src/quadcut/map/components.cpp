// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/components.hpp"

#include <vector>

namespace quadcut {
namespace {

/// A building fills at least this much of the ground around it; less are things inside of one.
constexpr double kMinBuildingShare = 0.05;

/// Of each part, on the border of the raster.
std::vector<std::uint32_t> num_border_cells(const ConnectedParts& parts) {
    std::vector<std::uint32_t> result(parts.count + std::size_t{1}, 0);
    const auto width = static_cast<std::size_t>(parts.width);
    const std::size_t last_row = width * (parts.row_begin.size() - 2);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        const bool is_edge_row = first < width || first >= last_row;
        const std::uint32_t num_ends =
            (run.begin == 0 ? 1U : 0U) + (run.end == width && width > 1 ? 1U : 0U);
        result[run.part] += is_edge_row ? run.end - run.begin : num_ends;
    });
    return result;
}

}  // namespace

ConnectedParts free_parts(const Raster<CellState>& states, const Executor& executor) {
    return connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free ? 1U : 0U; },
        Connectivity::four, executor);
}

std::uint32_t find_outside(const ConnectedParts& free, std::size_t min_cells) {
    const auto width = static_cast<std::size_t>(free.width);
    const std::size_t height = free.row_begin.size() - 1;
    const std::size_t border =
        width < 2 || height < 2 ? width * height : 2 * width + 2 * height - 4;
    const std::vector<std::size_t> num_cells = free.num_cells();
    const std::vector<std::uint32_t> num_border = num_border_cells(free);
    std::uint32_t outside = 0;
    std::size_t num_others = 0;
    for (std::uint32_t part = 1; part <= free.count; ++part) {
        if (2 * std::size_t{num_border[part]} > border) {
            outside = part;
        } else if (num_cells[part] >= min_cells) {
            num_others += num_cells[part];
        }
    }
    const bool is_building = static_cast<double>(num_others) <
                             kMinBuildingShare * static_cast<double>(num_cells[outside]);
    return is_building ? 0 : outside;
}

}  // namespace quadcut
