// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What rooms have beyond the window that is being cut: looked at tile by tile, since a room may go
// on for kilometres, and the box around it may hold next to nothing of it.
#include <algorithm>
#include <bit>
#include <utility>

#include "quadcut/follow/follower.hpp"

namespace quadcut {
namespace {

/// As in RegionGraph: a robot fits through, to somewhere.
constexpr float kFitsM = 0.25F;
constexpr double kPlaceM2 = 2.0;

Cell cell_in(Cell tile, int place) {
    const Cell low = first_cell_of(tile);
    return {low.x + place % kTileSide, low.y + place / kTileSide};
}

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

}  // namespace

BeyondWindow Follower::look_beyond(const LocalWindow& window, std::uint32_t room,
                                   const std::vector<Cell>& parts,
                                   const Raster<std::uint32_t>& pieces) {
    const Outside& outside = outside_[room] = groups_outside(window, room, parts, pieces);
    BeyondWindow beyond{outside.group_of_part, {}};
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    for (std::size_t group = 0; group < outside.num_cells.size(); ++group) {
        beyond.groups.push_back({static_cast<double>(outside.num_cells[group]) * cell_m2,
                                 outside.num_cells[group] == 0 ? 0.0 : rooms_.at(room).peak_m,
                                 openings_outside(window, room, outside, group)});
    }
    return beyond;
}

Follower::Outside Follower::groups_outside(const LocalWindow& window, std::uint32_t room,
                                           const std::vector<Cell>& parts,
                                           const Raster<std::uint32_t>& pieces) const {
    const FollowedRoom& known = rooms_.at(room);
    const auto num_inside = static_cast<std::size_t>(
        std::count(window.rooms.values.begin(), window.rooms.values.end(), room));
    if (parts.size() == 1) return {{0}, {known.num_cells - num_inside}, {}};
    // Several parts: a walk through the room, around what is cut anew, tells which are connected.
    // Furniture that was no room yet may stand for a part.
    std::set<std::uint32_t> pieces_of_parts;
    for (const Cell part : parts) pieces_of_parts.insert(pieces.at(part));
    TileWalk walk([&](Cell tile) {
        const std::uint64_t own = rows_of(cells_.tile(tile), room);
        return without_unwanted(tile, own, pieces, [&](Cell cell) {
            return pieces_of_parts.count(pieces.at(cell)) != 0;
        });
    });
    Outside outside;
    for (const Cell part : parts) {
        std::size_t group = 0;
        while (group < outside.groups.size() && !outside.groups[group].contains(part)) ++group;
        outside.group_of_part.push_back(group);
        if (group < outside.groups.size()) continue;
        outside.groups.push_back(walk.take(part));
        std::size_t num_cells = 0;
        outside.groups.back().for_each([&](Cell tile, std::uint64_t rows) {
            rows = without_unwanted(tile, rows, pieces, [](Cell) { return false; });
            num_cells += static_cast<std::size_t>(std::popcount(rows));
        });
        outside.num_cells.push_back(num_cells);
    }
    return outside;
}

std::size_t Follower::openings_outside(const LocalWindow& window, std::uint32_t room,
                                       const Outside& outside, std::size_t group) const {
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    std::set<std::uint32_t> neighbours;
    for (const LocalOpening& opening : openings_) {
        if (opening.clearance_m <= kFitsM || window.states.contains(opening.a)) continue;
        for (const auto& [own, far] :
             {std::pair{opening.a, opening.b}, std::pair{opening.b, opening.a}}) {
            const std::uint32_t other = cells_.room(far);
            if (cells_.room(own) != room || other == room || other == 0) continue;
            if (!outside.groups.empty() && !outside.groups[group].contains(own)) continue;
            const bool is_place =
                static_cast<double>(rooms_.at(other).num_cells) * cell_m2 >= kPlaceM2;
            if (is_place) neighbours.insert(other);
        }
    }
    return neighbours.size();
}

std::vector<Cell> Follower::cells_outside(const LocalWindow& window, std::uint32_t room,
                                          std::size_t group) const {
    const Outside& outside = outside_.at(room);
    const Box& box = rooms_.at(room).box;
    std::vector<Cell> cells;
    const auto add = [&](Cell tile, std::uint64_t rows) {
        rows &= rows_of(cells_.tile(tile), room);
        for (; rows != 0; rows &= rows - 1) {
            const Cell cell = cell_in(tile, std::countr_zero(rows));
            if (!window.states.contains(cell)) cells.push_back(cell);
        }
    };
    if (!outside.groups.empty()) {
        outside.groups[group].for_each(add);
        return cells;
    }
    for_each_cell({tile_of(box.low), tile_of(box.high)}, [&](Cell tile) {
        if (cells_.contains(tile)) add(tile, ~std::uint64_t{0});
    });
    return cells;
}

}  // namespace quadcut
