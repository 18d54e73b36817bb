// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tile_set.hpp"

#include <array>
#include <vector>

namespace quadcut {
namespace {

constexpr std::uint64_t kFirstColumn = 0x0101010101010101;
constexpr std::uint64_t kLastColumn = kFirstColumn << 7U;
constexpr unsigned kLastRow = 56;

std::uint64_t spread(std::uint64_t rows) {
    return rows | (rows & ~kLastColumn) << 1U | (rows & ~kFirstColumn) >> 1U | rows << 8U |
           rows >> 8U;
}

}  // namespace

TileSet TileWalk::take(Cell from) {
    TileSet taken;
    taken.rows(tile_of(from)) = std::uint64_t{1} << place_in_tile(from);
    std::vector<Cell> waiting{tile_of(from)};
    while (!waiting.empty()) {
        const Cell tile = waiting.back();
        waiting.pop_back();
        std::uint64_t& rows = taken.rows(tile);
        const std::uint64_t own = ways_.rows(tile, ways_of_);
        for (std::uint64_t before = 0; rows != before;) {
            before = rows;
            rows |= spread(rows) & own;
        }
        const std::uint64_t here = rows;
        const std::array<std::pair<Cell, std::uint64_t>, 4> steps{
            {{{tile.x + 1, tile.y}, (here & kLastColumn) >> 7U},
             {{tile.x - 1, tile.y}, (here & kFirstColumn) << 7U},
             {{tile.x, tile.y + 1}, here >> kLastRow},
             {{tile.x, tile.y - 1}, here << kLastRow}}};
        for (const auto& [next, entered] : steps) {
            if (entered == 0) continue;
            std::uint64_t is_new = entered & ways_.rows(next, ways_of_);
            if (is_new == 0) continue;
            std::uint64_t& there = taken.rows(next);
            is_new &= ~there;
            there |= is_new;
            if (is_new != 0) waiting.push_back(next);
        }
    }
    taken.for_each([&](Cell tile, std::uint64_t rows) { ways_.rows(tile) &= ~rows; });
    return taken;
}

}  // namespace quadcut
