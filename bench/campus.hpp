// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "bench/building_case.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"
#include "sim/building.hpp"

namespace quadcut {

/// About this many rooms are in one building of a campus.
inline constexpr int kRoomsOfBuilding = 40;
inline constexpr std::int32_t kStreetCells = 80;

namespace campus {

/// What is unknown around the building becomes open ground; what is unknown in it stays.
inline void open_ground(Raster<CellState>& states) {
    std::vector<Cell> open;
    const auto visit = [&](Cell cell) {
        if (!states.contains(cell) || states.at(cell) != CellState::unknown) return;
        states.at(cell) = CellState::free;
        open.push_back(cell);
    };
    const Box box = states.box();
    for (std::int32_t x = box.low.x; x <= box.high.x; ++x) {
        visit({x, box.low.y});
        visit({x, box.high.y});
    }
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y) {
        visit({box.low.x, y});
        visit({box.high.x, y});
    }
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        visit({cell.x + 1, cell.y});
        visit({cell.x - 1, cell.y});
        visit({cell.x, cell.y + 1});
        visit({cell.x, cell.y - 1});
    }
}

/// Buildings one beside the other in rows of about `width`, with streets between.
inline std::vector<Cell> places(const std::vector<Raster<CellState>>& buildings, std::int32_t width,
                                Cell& size) {
    std::vector<Cell> lower_left;
    Cell at{kStreetCells, kStreetCells};
    std::int32_t row_height = 0;
    size = {0, 0};
    for (const Raster<CellState>& building : buildings) {
        if (at.x > kStreetCells && at.x + building.width > width) {
            at = {kStreetCells, at.y + row_height + kStreetCells};
            row_height = 0;
        }
        lower_left.push_back(at);
        at.x += building.width + kStreetCells;
        row_height = std::max(row_height, building.height);
        size = {std::max(size.x, at.x), std::max(size.y, at.y + row_height + kStreetCells)};
    }
    return lower_left;
}

}  // namespace campus

/// Simulated buildings, half furnished, some turned, on open ground: together about `num_rooms`
/// rooms at 5 cm. The same numbers give the same campus; another one for each `draw`.
inline GridMap campus_of(int num_rooms, int draw = 0) {
    const int count = std::max(1, (num_rooms + kRoomsOfBuilding / 2) / kRoomsOfBuilding);
    std::vector<Raster<CellState>> buildings(static_cast<std::size_t>(count));
    double cells = 0.0;
    parallel_for(Executor{2}, buildings.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            sim::BuildingOptions options;
            const std::size_t number = static_cast<std::size_t>(draw) * buildings.size() + i;
            options.seed = kFirstSeed + 1000 + number;
            options.num_rooms = std::max(3, num_rooms / count);
            options.yaw_rad = number % 4 == 3 ? 0.3 : 0.0;
            buildings[i] = sim::generate_building(options).map.states;
            campus::open_ground(buildings[i]);
        }
    });
    for (const Raster<CellState>& building : buildings) {
        cells += static_cast<double>(building.width + kStreetCells) *
                 static_cast<double>(building.height + kStreetCells);
    }
    Cell size;
    const std::vector<Cell> lower_left =
        campus::places(buildings, static_cast<std::int32_t>(1.1 * std::sqrt(cells)), size);
    GridMap map{0.05, {}, Raster<CellState>({0, 0}, size.x, size.y, CellState::free)};
    for (std::size_t i = 0; i < buildings.size(); ++i) {
        const Raster<CellState>& building = buildings[i];
        for (std::int32_t y = 0; y < building.height; ++y) {
            const auto row =
                building.values.begin() + static_cast<std::ptrdiff_t>(y) * building.width;
            std::copy(row, row + building.width,
                      &map.states.at({lower_left[i].x, lower_left[i].y + y}));
        }
    }
    return map;
}

/// Three to eight wings of 12 to 24 rooms, joined by walkways, empty to full, some turned: what
/// zones are measured on. Another one for each `draw`.
inline sim::BuildingOptions campus_of_wings(std::size_t draw) {
    sim::BuildingOptions options;
    options.seed = kFirstSeed + 2000 + draw;
    options.furniture = kFurniture[draw % kFurniture.size()];
    options.yaw_rad = draw % 4 == 3 ? 0.3 : 0.0;
    options.num_wings = 3 + static_cast<int>(draw % 6);
    options.num_rooms = options.num_wings * (12 + static_cast<int>(draw * 7 % 13));
    return options;
}

/// The wing, from 1 on, that most of each room's cells are in, by place; 0: in none.
inline std::vector<std::uint32_t> wings_of_rooms(const sim::Building& building,
                                                 const Segmentation& rooms) {
    std::vector<std::map<std::uint32_t, std::size_t>> cells(rooms.rooms.size());
    for (std::size_t i = 0; i < rooms.labels.values.size(); ++i) {
        const std::uint16_t room = rooms.labels.values[i];
        const std::uint16_t truth = building.labels.values[i];
        if (room == 0 || truth == 0) continue;
        const int wing = building.rooms[truth - std::size_t{1}].wing;
        ++cells[room - std::size_t{1}][static_cast<std::uint32_t>(wing) + 1];
    }
    std::vector<std::uint32_t> wings;
    for (const auto& counts : cells) {
        std::pair<std::uint32_t, std::size_t> most{0, 0};
        for (const auto& count : counts) {
            if (count.second > most.second) most = count;
        }
        wings.push_back(most.first);
    }
    return wings;
}

}  // namespace quadcut
