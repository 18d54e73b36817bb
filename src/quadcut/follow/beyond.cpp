// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/beyond.hpp"

#include <algorithm>
#include <bit>
#include <set>
#include <utility>

namespace quadcut {
namespace {

/// The cells of a room, bit 8 y + x.
std::uint64_t rows_of(const RoomTile& tile, std::uint32_t room) {
    std::uint64_t rows = 0;
    for (std::size_t i = 0; i < kTileCells; ++i) {
        rows |= std::uint64_t{tile.rooms[i] == room} << i;
    }
    return rows;
}

/// `rows` without the cells in `raster` that are not wanted.
template <typename IsWanted>
std::uint64_t without_unwanted(Cell tile, std::uint64_t rows, const Raster<std::uint32_t>& raster,
                               const IsWanted& is_wanted) {
    if (cells_of_tiles({tile, tile}).intersected(raster.box()).is_empty()) return rows;
    for (std::uint64_t rest = rows; rest != 0; rest &= rest - 1) {
        const Cell cell = cell_in(tile, std::countr_zero(rest));
        if (raster.contains(cell) && !is_wanted(cell)) rows ^= rest & (~rest + 1);
    }
    return rows;
}

/// To how many rooms that are somewhere to go to a group has openings.
std::size_t openings_outside(const FollowedMap& followed, const Box& window, std::uint32_t room,
                             const Outside& outside, std::size_t group) {
    std::set<std::uint32_t> neighbours;
    for (const RoomOpening& opening : followed.openings) {
        if (opening.clearance_m <= kFitsM || window.contains(opening.a)) continue;
        for (const auto& [own, far] :
             {std::pair{opening.a, opening.b}, std::pair{opening.b, opening.a}}) {
            const std::uint32_t other = followed.cells.room(far);
            if (followed.cells.room(own) != room || other == room || other == 0) continue;
            if (!outside.groups.empty() && !outside.groups[group].contains(own)) continue;
            const auto num_cells = static_cast<double>(followed.rooms.at(other).num_cells);
            if (num_cells * followed.cell_m2() >= kPlaceM2) neighbours.insert(other);
        }
    }
    return neighbours.size();
}

}  // namespace

Outside look_outside(const FollowedMap& followed, const Window& window, std::uint32_t room,
                     const std::vector<Cell>& parts, const Raster<std::uint32_t>& labels) {
    const auto num_inside = static_cast<std::size_t>(
        std::count(window.rooms.values.begin(), window.rooms.values.end(), room));
    if (parts.size() == 1) return {{0}, {followed.rooms.at(room).num_cells - num_inside}, {}, 0};
    // Several parts: a walk through the room, around what is cut anew, tells which are connected.
    // Furniture that was no room yet may stand for a part.
    std::set<std::uint32_t> ways;
    for (const Cell part : parts) ways.insert(labels.at(part));
    Outside outside;
    TileWalk walk([&](Cell tile) {
        outside.cells_read += kTileCells;
        return without_unwanted(tile, rows_of(followed.cells.tile(tile), room), labels,
                                [&](Cell cell) { return ways.count(labels.at(cell)) != 0; });
    });
    for (const Cell part : parts) {
        std::size_t group = 0;
        while (group < outside.groups.size() && !outside.groups[group].contains(part)) ++group;
        outside.group_of_part.push_back(group);
        if (group < outside.groups.size()) continue;
        outside.groups.push_back(walk.take(part));
        std::size_t num_cells = 0;
        outside.groups.back().for_each([&](Cell tile, std::uint64_t rows) {
            rows = without_unwanted(tile, rows, labels, [](Cell) { return false; });
            num_cells += static_cast<std::size_t>(std::popcount(rows));
        });
        outside.num_cells.push_back(num_cells);
    }
    return outside;
}

std::vector<Beyond> beyond_of(const FollowedMap& followed, const Box& window, std::uint32_t room,
                              const Outside& outside) {
    std::vector<Beyond> groups;
    for (std::size_t group = 0; group < outside.num_cells.size(); ++group) {
        const std::size_t num_cells = outside.num_cells[group];
        groups.push_back({static_cast<double>(num_cells) * followed.cell_m2(),
                          num_cells == 0 ? 0.0 : followed.rooms.at(room).peak_m,
                          openings_outside(followed, window, room, outside, group)});
    }
    return groups;
}

std::vector<Cell> cells_outside(const FollowedMap& followed, const Window& window,
                                std::uint32_t room, const Outside& outside, std::size_t group) {
    std::vector<Cell> cells;
    const auto add = [&](Cell tile, std::uint64_t rows) {
        rows &= rows_of(followed.cells.tile(tile), room);
        for (; rows != 0; rows &= rows - 1) {
            const Cell cell = cell_in(tile, std::countr_zero(rows));
            if (!window.states.contains(cell)) cells.push_back(cell);
        }
    };
    if (!outside.groups.empty()) {
        outside.groups[group].for_each(add);
        return cells;
    }
    const Box& box = followed.rooms.at(room).box;
    for_each_cell({tile_of(box.low), tile_of(box.high)}, [&](Cell tile) {
        if (followed.cells.contains(tile)) add(tile, ~std::uint64_t{0});
    });
    return cells;
}

}  // namespace quadcut
