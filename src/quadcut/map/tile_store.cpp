// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tile_store.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace quadcut {

namespace {

bool has_one_value(const Tile& tile) {
    // Each is as the one before it.
    return std::memcmp(tile.values.data(), tile.values.data() + 1, kTileCells - 1) == 0;
}

}  // namespace

TileStore::TileStore() : tiles_(kNumUniform) {
    for (std::uint32_t entry = 0; entry < kNumUniform; ++entry) {
        const int value = kMinLogOdds + static_cast<int>(entry);
        tiles_[entry].values.fill(static_cast<std::int8_t>(value));
    }
}

void TileStore::set_tile(Cell tile, const Tile& values) {
    const bool had_bytes = !is_uniform(tile);
    if (has_one_value(values)) {
        if (had_bytes) free_.push_back(number(tile));
        set_number(tile, uniform_number(values.values.front()));
    } else {
        if (!had_bytes) set_number(tile, new_place());
        tiles_[number(tile)] = values;
    }
}

std::uint32_t TileStore::new_place() {
    if (!free_.empty()) {
        const std::uint32_t place = free_.back();
        free_.pop_back();
        return place;
    }
    if (tiles_.size() == tiles_.capacity()) {
        // An eighth at a time: a quarter of a doubled pool would lie idle on average.
        tiles_.reserve(tiles_.size() + std::max<std::size_t>(32, tiles_.size() / 8));
    }
    tiles_.emplace_back();
    return static_cast<std::uint32_t>(tiles_.size() - 1);
}

void TileStore::set_rectangle(const Box& tiles) {
    TileStore larger;
    larger.directory_ = Raster<std::uint32_t>(tiles);
    for (std::size_t i = 0; i < larger.directory_.values.size(); ++i) {
        const Cell tile = larger.directory_.cell(i);
        larger.set_number(tile, number(tile));
    }
    directory_ = std::move(larger.directory_);
    low_x_ = static_cast<std::uint32_t>(tiles.low.x) * kTileSide;
    low_y_ = static_cast<std::uint32_t>(tiles.low.y) * kTileSide;
    width_ = static_cast<std::uint32_t>(directory_.width) * kTileSide;
    height_ = static_cast<std::uint32_t>(directory_.height) * kTileSide;
}

void TileStore::give_back() {
    if (free_.size() > 32 && free_.size() > num_tiles() / 8) compact();
}

void TileStore::compact() {
    std::vector<Tile> tiles;
    tiles.reserve(kNumUniform + num_tiles());
    tiles.assign(tiles_.begin(), tiles_.begin() + kNumUniform);
    for (std::size_t i = 0; i < directory_.values.size(); ++i) {
        const Cell tile = directory_.cell(i);
        if (is_uniform(tile)) continue;
        tiles.push_back(tiles_[number(tile)]);
        set_number(tile, static_cast<std::uint32_t>(tiles.size() - 1));
    }
    tiles_ = std::move(tiles);
    free_ = std::vector<std::uint32_t>{};
}

std::size_t TileStore::bytes() const {
    return directory_.values.capacity() * sizeof(std::uint32_t) + tiles_.capacity() * sizeof(Tile) +
           free_.capacity() * sizeof(std::uint32_t);
}

}  // namespace quadcut
