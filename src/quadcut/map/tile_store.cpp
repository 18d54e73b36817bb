// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tile_store.hpp"

#include <algorithm>
#include <utility>

namespace quadcut {

namespace {

bool has_one_value(const Tile& tile) {
    const std::int8_t first = tile.values.front();
    return std::all_of(tile.values.begin(), tile.values.end(),
                       [=](std::int8_t value) { return value == first; });
}

}  // namespace

TileStore::TileStore() : tiles_(kNumUniform) {
    for (std::uint32_t entry = 0; entry < kNumUniform; ++entry) {
        const int value = kMinLogOdds + static_cast<int>(entry);
        tiles_[entry].values.fill(static_cast<std::int8_t>(value));
    }
}

Tile& TileStore::writable_tile(Cell tile) {
    std::uint32_t& entry = directory_.at(tile);
    if (entry >= kNumUniform) return tiles_[entry];
    const Tile uniform = tiles_[entry];
    if (!free_.empty()) {
        entry = free_.back();
        free_.pop_back();
        tiles_[entry] = uniform;
        return tiles_[entry];
    }
    if (tiles_.size() == tiles_.capacity()) {
        // An eighth at a time: a quarter of a doubled pool would lie idle on average.
        tiles_.reserve(tiles_.size() + std::max<std::size_t>(32, tiles_.size() / 8));
    }
    entry = static_cast<std::uint32_t>(tiles_.size());
    tiles_.push_back(uniform);
    return tiles_.back();
}

void TileStore::set_tile(Cell tile, const Tile& values) {
    if (has_one_value(values)) {
        make_uniform(tile, values.values.front());
    } else {
        writable_tile(tile) = values;
    }
}

void TileStore::make_uniform(Cell tile, int log_odds) {
    std::uint32_t& entry = directory_.at(tile);
    if (entry >= kNumUniform) free_.push_back(entry);
    entry = uniform_number(log_odds);
}

void TileStore::collapse(Cell tile) {
    if (is_uniform(tile)) return;
    const Tile& values = tiles_[directory_.at(tile)];
    if (has_one_value(values)) make_uniform(tile, values.values.front());
}

void TileStore::set_rectangle(Cell low, Cell high) {
    Raster<std::uint32_t> larger(low, high.x - low.x + 1, high.y - low.y + 1, uniform_number(0));
    for (std::int32_t row = 0; row < directory_.height; ++row) {
        const Cell first{directory_.origin.x, directory_.origin.y + row};
        const auto from = directory_.values.begin() + std::ptrdiff_t{row} * directory_.width;
        std::copy(from, from + directory_.width,
                  larger.values.begin() + static_cast<std::ptrdiff_t>(larger.offset(first)));
    }
    directory_ = std::move(larger);
}

void TileStore::give_back() {
    if (free_.size() > 32 && free_.size() > num_tiles() / 8) compact();
}

void TileStore::compact() {
    std::vector<Tile> tiles;
    tiles.reserve(kNumUniform + num_tiles());
    tiles.assign(tiles_.begin(), tiles_.begin() + kNumUniform);
    for (std::uint32_t& number : directory_.values) {
        if (number >= kNumUniform) {
            tiles.push_back(tiles_[number]);
            number = static_cast<std::uint32_t>(tiles.size() - 1);
        }
    }
    tiles_ = std::move(tiles);
    free_ = std::vector<std::uint32_t>{};
}

std::size_t TileStore::bytes() const {
    return directory_.values.capacity() * sizeof(std::uint32_t) + tiles_.capacity() * sizeof(Tile) +
           free_.capacity() * sizeof(std::uint32_t);
}

}  // namespace quadcut
