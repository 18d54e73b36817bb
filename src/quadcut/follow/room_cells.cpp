// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/room_cells.hpp"

#include <algorithm>
#include <utility>

namespace quadcut {
namespace {

/// A side that is passed moves by so much at least, so that growing is cheap.
std::int32_t spare(std::int32_t extent) { return std::max(32, extent / 8); }

Box grown_to(const Box& box, Cell tile) {
    if (box.is_empty()) return {tile, tile};
    Box grown = box;
    if (tile.x < box.low.x) grown.low.x = std::min(tile.x, box.low.x - spare(box.width()));
    if (tile.y < box.low.y) grown.low.y = std::min(tile.y, box.low.y - spare(box.height()));
    if (tile.x > box.high.x) grown.high.x = std::max(tile.x, box.high.x + spare(box.width()));
    if (tile.y > box.high.y) grown.high.y = std::max(tile.y, box.high.y + spare(box.height()));
    return grown;
}

}  // namespace

bool RoomCells::set_room(Cell cell, std::uint32_t room) {
    if (this->room(cell) == room) return false;
    tiles_[number(tile_of(cell))].rooms[place_in_tile(cell)] = room;
    return true;
}

bool RoomCells::set_cut_free(Cell cell, bool is_free) {
    const std::uint64_t bit = std::uint64_t{1} << place_in_tile(cell);
    if (((tile(tile_of(cell)).cut_free & bit) != 0) == is_free) return false;
    tiles_[number(tile_of(cell))].cut_free ^= bit;
    return true;
}

void RoomCells::note_free(Cell tile, int num_free) {
    std::uint8_t& before = num_free_[number(tile)];
    moments_.add(tile, num_free - std::int64_t{before});
    before = static_cast<std::uint8_t>(num_free);
}

void RoomCells::Moments::add(Cell tile, std::int64_t cells) {
    count += cells;
    Integer x_power = cells;
    Integer y_power = cells;
    for (std::size_t k = 0; k < 3; ++k) {
        x_power *= tile.x;
        y_power *= tile.y;
        x[k] += x_power;
        y[k] += y_power;
    }
}

Layout RoomCells::orientation() const {
    if (moments_.count == 0) return {};
    const auto of = [&](const auto& sums) {
        const auto n = static_cast<double>(moments_.count);
        return AxisMoments{n, static_cast<double>(sums[0]), static_cast<double>(sums[1]),
                           static_cast<double>(sums[2])};
    };
    return standard_orientation(of(moments_.x), of(moments_.y));
}

std::size_t RoomCells::bytes() const {
    return directory_.values.capacity() * sizeof(std::uint32_t) +
           tiles_.capacity() * sizeof(RoomTile) + num_free_.capacity();
}

std::uint32_t RoomCells::number(Cell tile) {
    if (!directory_.contains(tile)) {
        const Box before = directory_.values.empty() ? Box{} : directory_.box();
        Raster<std::uint32_t> larger(grown_to(before, tile));
        for (std::size_t i = 0; i < directory_.values.size(); ++i) {
            larger.at(directory_.cell(i)) = directory_.values[i];
        }
        directory_ = std::move(larger);
    }
    std::uint32_t& entry = directory_.at(tile);
    if (entry == 0) {
        // An eighth at a time: memory goes with what was seen.
        if (tiles_.size() == tiles_.capacity()) {
            tiles_.reserve(tiles_.size() + std::max<std::size_t>(64, tiles_.size() / 8));
        }
        entry = static_cast<std::uint32_t>(tiles_.size());
        tiles_.emplace_back();
        num_free_.push_back(0);
    }
    return entry;
}

}  // namespace quadcut
