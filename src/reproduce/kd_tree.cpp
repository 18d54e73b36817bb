// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/kd_tree.hpp"

#include <cstdint>

#include <nanoflann.hpp>

namespace quadcut {
namespace {

/// Points in the form that nanoflann asks for them.
struct Points {
    std::span<const Cell> cells;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return cells.size(); }
    [[nodiscard]] std::int32_t kdtree_get_pt(std::size_t i, std::size_t dimension) const {
        return dimension == 0 ? cells[i].x : cells[i].y;
    }
    template <typename Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }
};

using Distance = nanoflann::L2_Simple_Adaptor<std::int32_t, Points, double>;
using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Points, 2>;

}  // namespace

std::vector<Cell> obstacles_of(const OccupancyMap& map) {
    std::vector<Cell> cells;
    const Box tiles = map.written_tiles();
    for (Cell tile = tiles.low; tile.y <= tiles.high.y; ++tile.y) {
        for (tile.x = tiles.low.x; tile.x <= tiles.high.x; ++tile.x) {
            const Tile& values = map.tile(tile);
            const Cell low = first_cell_of(tile);
            for (std::size_t i = 0; i < kTileCells; ++i) {
                if (values.values[i] <= 0) continue;
                cells.push_back({low.x + static_cast<std::int32_t>(i % kTileSide),
                                 low.y + static_cast<std::int32_t>(i / kTileSide)});
            }
        }
    }
    return cells;
}

std::size_t build_kd_tree(std::span<const Cell> points) {
    const Points source{points};
    const Tree tree(2, source);
    return tree.size(tree);
}

}  // namespace quadcut
