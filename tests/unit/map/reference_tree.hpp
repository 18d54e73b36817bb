// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf.hpp"
#include "quadcut/map/root.hpp"

/// Maps drawn as text, and the quadtree by plain recursion over single cells.
namespace quadcut::test {

/// Rows from the top down: '.' free, '#' occupied, anything else unknown. The lower left is (0, 0).
inline GridMap grid_from_text(const std::vector<std::string>& rows) {
    const auto width = rows.empty() ? 0 : static_cast<std::int32_t>(rows.front().size());
    const auto height = static_cast<std::int32_t>(rows.size());
    GridMap grid{0.05, {}, Raster<CellState>({0, 0}, width, height)};
    for (std::int32_t y = 0; y < height; ++y) {
        const std::string& row = rows[static_cast<std::size_t>(height - 1 - y)];
        for (std::int32_t x = 0; x < width; ++x) {
            const char cell = row[static_cast<std::size_t>(x)];
            grid.states.at({x, y}) = cell == '.'   ? CellState::free
                                     : cell == '#' ? CellState::occupied
                                                   : CellState::unknown;
        }
    }
    return grid;
}

/// The other way, '?' for unknown.
inline std::vector<std::string> text_from(const Raster<CellState>& states) {
    std::vector<std::string> rows;
    for (std::int32_t y = states.height - 1; y >= 0; --y) {
        std::string row;
        for (std::int32_t x = 0; x < states.width; ++x) {
            row += "?.#"[static_cast<int>(states.at({states.origin.x + x, states.origin.y + y}))];
        }
        rows.push_back(row);
    }
    return rows;
}

struct ReferenceTree {
    std::vector<Leaf> leaves;  // depth first
    std::vector<Root> inner_nodes;
};

/// Divides `block` down to single cells and joins what is equal on the way back.
template <typename StateOf>
bool is_uniform(const Root& block, const StateOf& state_of_cell) {
    const CellState first = state_of_cell(block.lower_left);
    for (std::int32_t y = 0; y < block.side_cells(); ++y) {
        for (std::int32_t x = 0; x < block.side_cells(); ++x) {
            if (state_of_cell(Cell{block.lower_left.x + x, block.lower_left.y + y}) != first) {
                return false;
            }
        }
    }
    return true;
}

template <typename StateOf>
void append_tree(const Root& block, const StateOf& state_of_cell, ReferenceTree& tree) {
    if (is_uniform(block, state_of_cell)) {
        tree.leaves.push_back({block.lower_left, block.level, state_of_cell(block.lower_left)});
        return;
    }
    tree.inner_nodes.push_back(block);
    const std::int32_t half = block.side_cells() / 2;
    for (const Cell corner : {Cell{0, 0}, Cell{half, 0}, Cell{0, half}, Cell{half, half}}) {
        append_tree(Root{{block.lower_left.x + corner.x, block.lower_left.y + corner.y},
                         static_cast<std::uint8_t>(block.level - 1)},
                    state_of_cell, tree);
    }
}

template <typename StateOf>
ReferenceTree reference_tree(const Root& root, const StateOf& state_of_cell) {
    ReferenceTree tree;
    append_tree(root, state_of_cell, tree);
    return tree;
}

}  // namespace quadcut::test
