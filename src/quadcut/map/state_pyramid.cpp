// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/state_pyramid.hpp"

#include <algorithm>

namespace quadcut {

StatePyramid::StatePyramid(int num_layers, Cell low, Cell high) {
    layers_.reserve(static_cast<std::size_t>(num_layers));
    for (int layer = 0; layer < num_layers; ++layer) {
        const Cell first{low.x >> layer, low.y >> layer};
        layers_.emplace_back(first, (high.x >> layer) - first.x + 1,
                             (high.y >> layer) - first.y + 1, std::uint8_t{0});
    }
}

void StatePyramid::set_tile(Cell position, const TileStates& states) {
    const int count = leaves_of(states).count();
    layers_.front().at(position) =
        static_cast<std::uint8_t>(count == 0 ? static_cast<int>(states.at(0)) : count);
}

void StatePyramid::take_tiles(const StatePyramid& smaller, Cell shift) {
    const Raster<std::uint8_t>& from = smaller.layers_.front();
    Raster<std::uint8_t>& to = layers_.front();
    for (std::int32_t row = 0; row < from.height; ++row) {
        const auto first = from.values.begin() + std::ptrdiff_t{row} * from.width;
        const Cell target{from.origin.x + shift.x, from.origin.y + row + shift.y};
        std::copy(first, first + from.width,
                  to.values.begin() + static_cast<std::ptrdiff_t>(to.offset(target)));
    }
}

BlockState StatePyramid::from_children(int layer, Cell position) const {
    const Cell child{position.x * 2, position.y * 2};
    const BlockState first = at(layer - 1, child);
    if (at(layer - 1, {child.x + 1, child.y}) != first ||
        at(layer - 1, {child.x, child.y + 1}) != first ||
        at(layer - 1, {child.x + 1, child.y + 1}) != first) {
        return BlockState::mixed;
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

std::size_t StatePyramid::bytes() const {
    std::size_t sum = layers_.capacity() * sizeof(Raster<std::uint8_t>);
    for (const Raster<std::uint8_t>& layer : layers_) sum += layer.values.capacity();
    return sum;
}

}  // namespace quadcut
