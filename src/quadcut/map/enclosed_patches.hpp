// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// What stands in a room as an island: a table, a shelf, an island of kitchen units. A court that
/// a corridor runs around is larger.
inline constexpr double kMaxFurnitureM2 = 16.0;

/// How many cells kMaxFurnitureM2 are.
[[nodiscard]] inline std::size_t max_furniture_cells(double resolution_m) {
    constexpr double kMost = 1e12;
    return static_cast<std::size_t>(
        std::min(kMaxFurnitureM2 / (resolution_m * resolution_m) + 0.5, kMost));
}

/// Finds patches of connected cells (8-connected) whose label is no room, of at most `max_cells`,
/// that one room encloses: not several, nor the edge of the raster. Calls `visit(run, offset of its
/// first cell, room)` for their runs, after which labels may change. O(cells).
template <typename Label, typename IsRoom, typename Visit>
void for_each_enclosed_run(const Raster<Label>& labels, const IsRoom& is_room,
                           std::size_t max_cells, const Executor& executor, const Visit& visit) {
    const ConnectedParts patches = connected_parts(
        labels, [&](std::size_t i) { return is_room(labels.values[i]) ? 0 : 1; },
        Connectivity::eight, executor);
    std::vector<bool> is_enclosed = patches.islands(static_cast<double>(max_cells) + 1.0);
    std::vector<Label> room_around(is_enclosed.size());
    const auto width = static_cast<std::size_t>(labels.width);
    patches.for_each_run([&](const CellRun& run, std::size_t first) {
        if (!is_enclosed[run.part]) return;
        Label& room = room_around[run.part];
        const auto meet = [&](std::size_t place) {
            const Label met = labels.values[place];
            if (!is_room(met)) return;
            if (room == 0) room = met;
            if (met != room) is_enclosed[run.part] = false;
        };
        const std::size_t last = first + (run.end - run.begin) - 1;
        meet(first - 1);
        meet(last + 1);
        for (std::size_t place = first - 1; place <= last + 1; ++place) {
            meet(place - width);
            meet(place + width);
        }
    });
    patches.for_each_run([&](const CellRun& run, std::size_t first) {
        const Label room = room_around[run.part];
        if (room != 0 && is_enclosed[run.part]) visit(run, first, room);
    });
}

}  // namespace quadcut
