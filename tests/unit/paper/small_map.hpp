// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf_table.hpp"

/// Small maps for the tests of the graph, and their leaves by plain recursion.
namespace quadcut::test {

using States = Raster<CellState>;

/// A square map of a power of two cells a side from rows of text, the top row first:
/// '.' free, '#' occupied, '?' unknown. Rows may be short: what is missing is unknown.
inline States map_from_text(const std::vector<std::string>& rows) {
    std::int32_t side = 1;
    while (side < static_cast<std::int32_t>(rows.size())) side *= 2;
    for (const std::string& row : rows) {
        while (side < static_cast<std::int32_t>(row.size())) side *= 2;
    }
    States states(Cell{0, 0}, side, side, CellState::unknown);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t x = 0; x < rows[i].size(); ++x) {
            const Cell cell{static_cast<std::int32_t>(x),
                            static_cast<std::int32_t>(rows.size() - 1 - i)};
            if (rows[i][x] == '.') states.at(cell) = CellState::free;
            if (rows[i][x] == '#') states.at(cell) = CellState::occupied;
        }
    }
    return states;
}

/// A free map with random single cells and bars of obstacles and patches of unknown. The origin is
/// any multiple of the side, so that negative cells are tried too.
inline States random_map(Random& random, std::int32_t side, double clutter) {
    const auto pick = [&](std::int32_t count) {
        return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(count)));
    };
    const Cell origin{(pick(3) - 1) * side, (pick(3) - 1) * side};
    States states(origin, side, side, CellState::free);
    for (CellState& state : states.values) {
        if (random.uniform() < clutter) {
            state = random.below(4) == 0 ? CellState::unknown : CellState::occupied;
        }
    }
    for (std::int32_t bar = pick(4); bar > 0; --bar) {
        const bool upright = pick(2) == 0;
        const std::int32_t line = pick(side);
        const std::int32_t first = pick(side);
        const std::int32_t last = first + pick(side - first);
        for (std::int32_t along = first; along <= last; ++along) {
            const Cell cell{origin.x + (upright ? line : along),
                            origin.y + (upright ? along : line)};
            states.at(cell) = CellState::occupied;
        }
    }
    return states;
}

inline void append_leaves(const States& states, Cell low, std::uint8_t level,
                          std::vector<Leaf>& leaves) {
    const std::int32_t side = std::int32_t{1} << level;
    const CellState state = states.at(low);
    bool uniform = true;
    for (std::int32_t y = low.y; y < low.y + side; ++y) {
        for (std::int32_t x = low.x; x < low.x + side; ++x) {
            uniform = uniform && states.at({x, y}) == state;
        }
    }
    if (uniform) {
        leaves.push_back({low, level, state});
        return;
    }
    const auto child = static_cast<std::uint8_t>(level - 1);
    const std::int32_t half = side / 2;
    append_leaves(states, low, child, leaves);
    append_leaves(states, {low.x + half, low.y}, child, leaves);
    append_leaves(states, {low.x, low.y + half}, child, leaves);
    append_leaves(states, {low.x + half, low.y + half}, child, leaves);
}

/// The quadtree leaves of a square map whose side is a power of two and whose origin is a multiple
/// of the side.
inline LeafTable table_of(const States& states) {
    std::uint8_t level = 0;
    while ((std::int32_t{1} << level) < states.width) ++level;
    std::vector<Leaf> leaves;
    append_leaves(states, states.origin, level, leaves);
    return {std::move(leaves), Root{states.origin, level}};
}

inline std::vector<LeafId> free_leaves(const LeafTable& table) {
    std::vector<LeafId> ids;
    for (std::uint32_t i = 0; i < table.leaves().size(); ++i) {
        if (table.leaves()[i].state == CellState::free) ids.push_back(LeafId{i});
    }
    return ids;
}

}  // namespace quadcut::test
