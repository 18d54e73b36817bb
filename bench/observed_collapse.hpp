// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>

#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"

// Step 2 of the paper's "Dynamic construction of quadtree" to the letter, beside ours: a subtree
// collapses when a scan sees all of it free; one that reaches out of the observed area stays,
// whatever is known of it. Ours collapses what is of one state, whoever saw it.
namespace quadcut {

class ObservedCollapse {
public:
    /// After the scan went into the map.
    void add(const OccupancyMap& map, const std::vector<TileEvidence>& evidence) {
        std::set<Cell, IsBefore> whole;
        for (const TileEvidence& one : evidence) {
            for (int level = 1; level <= kTileBits; ++level) add_blocks(map, one, level, whole);
        }
        for (int level = kTileBits + 1; level < kMaxLevel && !whole.empty(); ++level) {
            whole = add_parents(whole, level);
        }
    }

    /// The free leaves that the map's tree would have.
    [[nodiscard]] std::size_t num_free_leaves(const OccupancyMap& map) const {
        std::size_t count = 0;
        for (const Leaf& leaf : map.leaves()) {
            if (leaf.state == CellState::free) count += count_in(leaf.lower_left, leaf.level);
        }
        return count;
    }

private:
    struct IsBefore {
        bool operator()(Cell p, Cell q) const { return std::pair(p.y, p.x) < std::pair(q.y, q.x); }
    };
    static constexpr int kMaxLevel = 12;

    /// Blocks of a tile, relative to cell (0, 0) as those of the map's tree up to tiles are.
    void add_blocks(const OccupancyMap& map, const TileEvidence& one, int level,
                    std::set<Cell, IsBefore>& whole) {
        const std::int32_t side = 1 << level;
        for (std::int32_t y = 0; y < kTileSide; y += side) {
            for (std::int32_t x = 0; x < kTileSide; x += side) {
                const Cell low{first_cell_of(one.tile).x + x, first_cell_of(one.tile).y + y};
                bool is_seen = true;
                bool is_free = true;
                for_each_cell(Box{low, {low.x + side - 1, low.y + side - 1}}, [&](Cell cell) {
                    is_seen = is_seen && (one.miss >> place_in_tile(cell) & 1) != 0;
                    is_free = is_free && map.state(cell) == CellState::free;
                });
                if (!is_free) merged_[static_cast<std::size_t>(level)].erase(low);
                if (!is_free && level == kTileBits) forget_above(low);
                if (is_free && is_seen) merged_[static_cast<std::size_t>(level)].insert(low);
                if (is_free && is_seen && level == kTileBits) whole.insert(low);
            }
        }
    }

    static Cell aligned(Cell cell, int level) {
        const std::int32_t mask = (1 << level) - 1;
        return {cell.x - (cell.x & mask), cell.y - (cell.y & mask)};
    }

    void forget_above(Cell low) {
        for (int level = kTileBits + 1; level < kMaxLevel; ++level) {
            merged_[static_cast<std::size_t>(level)].erase(aligned(low, level));
        }
    }

    /// The blocks of which all four quarters were seen.
    std::set<Cell, IsBefore> add_parents(const std::set<Cell, IsBefore>& quarters, int level) {
        std::set<Cell, IsBefore> parents;
        const std::int32_t half = 1 << (level - 1);
        for (const Cell low : quarters) {
            if (aligned(low, level) != low) continue;
            if (quarters.count({low.x + half, low.y}) == 0 ||
                quarters.count({low.x, low.y + half}) == 0 ||
                quarters.count({low.x + half, low.y + half}) == 0) {
                continue;
            }
            parents.insert(low);
            merged_[static_cast<std::size_t>(level)].insert(low);
        }
        return parents;
    }

    [[nodiscard]] std::size_t count_in(Cell low, int level) const {
        if (level == 0 || merged_[static_cast<std::size_t>(level)].count(low) != 0) return 1;
        const std::int32_t half = 1 << (level - 1);
        std::size_t count = 0;
        for (const std::int32_t y : {low.y, low.y + half}) {
            for (const std::int32_t x : {low.x, low.x + half}) count += count_in({x, y}, level - 1);
        }
        return count;
    }

    std::array<std::set<Cell, IsBefore>, kMaxLevel> merged_;
};

}  // namespace quadcut
