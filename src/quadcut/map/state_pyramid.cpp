// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/state_pyramid.hpp"

namespace quadcut {

StatePyramid::StatePyramid(const Root& root, const Box& tiles) {
    layers_.reserve(static_cast<std::size_t>(root.level - kTileBits + 1));
    for (int level = kTileBits; level <= root.level; ++level) {
        layers_.emplace_back(Box{root.position(level, first_cell_of(tiles.low)),
                                 root.position(level, first_cell_of(tiles.high))});
    }
}

void StatePyramid::set_tile(Cell position, const TileStates& states) {
    const int count = leaves_of(states).count();
    layers_.front().at(position) =
        static_cast<std::uint8_t>(count == 0 ? static_cast<int>(states.at(0)) : count);
}

void StatePyramid::take_tiles(const StatePyramid& smaller, Cell position) {
    const Raster<std::uint8_t>& from = smaller.layers_.front();
    for (std::size_t i = 0; i < from.values.size(); ++i) {
        const Cell tile = from.cell(i);
        layers_.front().at({tile.x + position.x, tile.y + position.y}) = from.values[i];
    }
}

BlockState StatePyramid::from_children(int layer, Cell position) const {
    const BlockState first = at(layer - 1, child_of(position, 0));
    for (int quadrant = 1; quadrant < 4; ++quadrant) {
        if (at(layer - 1, child_of(position, quadrant)) != first) return BlockState::mixed;
    }
    return first;
}

void StatePyramid::rebuild() {
    for (int layer = 1; layer < num_layers(); ++layer) {
        const Raster<std::uint8_t>& nodes = layers_[static_cast<std::size_t>(layer)];
        for (std::size_t i = 0; i < nodes.values.size(); ++i) {
            const Cell position = nodes.cell(i);
            set(layer, position, from_children(layer, position));
        }
    }
}

std::size_t StatePyramid::num_leaves_in(int layer, Cell position) const {
    std::size_t num_leaves = 0;
    for_each_block(layer, position, [&](int block_layer, Cell block) {
        num_leaves += block_layer > 0 ? 1 : static_cast<std::size_t>(num_leaves_in_tile(block));
    });
    return num_leaves;
}

std::size_t StatePyramid::bytes() const {
    std::size_t sum = layers_.capacity() * sizeof(Raster<std::uint8_t>);
    for (const Raster<std::uint8_t>& layer : layers_) sum += layer.values.capacity();
    return sum;
}

}  // namespace quadcut
