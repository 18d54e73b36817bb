// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
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

/// Connected cells of no room (8-connected), and the room around each.
template <typename Label>
struct EnclosedPatches {
    ConnectedParts patches;
    /// 0 where several rooms or the edge of the raster meet the patch, and for patches too large.
    std::vector<Label> room_around;

    /// Calls `visit(run, offset of its first cell, room)` for what one room encloses.
    template <typename Visitor>
    void for_each_run(const Visitor& visit) const {
        patches.for_each_run([&](const CellRun& run, std::size_t first) {
            if (room_around[run.part] != 0) visit(run, first, room_around[run.part]);
        });
    }
};

/// The patches of cells whose label is no room, of at most `max_cells`, that one room encloses.
/// O(cells).
template <typename Label, typename IsRoom>
[[nodiscard]] EnclosedPatches<Label> enclosed_patches(const Raster<Label>& labels,
                                                      const IsRoom& is_room, std::size_t max_cells,
                                                      const Executor& executor = {}) {
    EnclosedPatches<Label> found{
        connected_parts(
            labels, [&](std::size_t i) { return is_room(labels.values[i]) ? 0 : 1; },
            Connectivity::eight, executor),
        {}};
    std::vector<bool> is_other = found.patches.on_edge();
    const std::vector<std::size_t> num_cells = found.patches.num_cells();
    for (std::size_t i = 1; i < is_other.size(); ++i) {
        if (num_cells[i] > max_cells) is_other[i] = true;
    }
    found.room_around.resize(is_other.size());
    const auto width = static_cast<std::size_t>(labels.width);
    found.patches.for_each_run([&](const CellRun& run, std::size_t first) {
        if (is_other[run.part]) return;
        Label& room = found.room_around[run.part];
        const auto meet = [&](std::size_t place) {
            const Label met = labels.values[place];
            if (!is_room(met)) return;
            if (room == 0) room = met;
            if (met != room) is_other[run.part] = true;
        };
        const std::size_t last = first + (run.end - run.begin) - 1;
        meet(first - 1);
        meet(last + 1);
        for (std::size_t place = first - 1; place <= last + 1; ++place) {
            meet(place - width);
            meet(place + width);
        }
    });
    for (std::size_t i = 1; i < is_other.size(); ++i) {
        if (is_other[i]) found.room_around[i] = 0;
    }
    return found;
}

}  // namespace quadcut
