// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/leaf_table.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

namespace quadcut {
namespace {

// 256 MB of directory: 3 km x 3 km at 5 cm. Maps keep below this themselves.
constexpr std::int64_t kMaxTiles = std::int64_t{1} << 26;
constexpr std::uint8_t kMaxRootLevel = 30;

bool is_aligned_inside(const Leaf& leaf, const Root& root) {
    if (leaf.level > root.level) return false;
    const std::int32_t mask = leaf.side_cells() - 1;
    const auto inside = [&](std::int32_t low, std::int32_t root_low) {
        return low >= root_low && ((low - root_low) & mask) == 0 &&
               std::int64_t{low} + leaf.side_cells() <= std::int64_t{root_low} + root.side_cells();
    };
    return inside(leaf.lower_left.x, root.lower_left.x) &&
           inside(leaf.lower_left.y, root.lower_left.y);
}

}  // namespace

LeafTable::LeafTable(std::vector<Leaf> leaves, const Root& root)
    : root_(root), leaves_(std::move(leaves)) {
    if (root.level > kMaxRootLevel) {
        throw std::logic_error("LeafTable: the root is larger than 2^30 cells");
    }
    if (leaves_.size() >= kMixed) throw std::logic_error("LeafTable: more than 2^31 leaves");
    frame_directory();
    for (std::uint32_t id = 0; id < leaves_.size(); ++id) {
        if (leaves_[id].state == CellState::unknown) continue;
        if (leaves_[id].level >= kTileBits) {
            add_large_leaf(id);
        } else {
            add_small_leaf(id);
        }
    }
}

std::size_t LeafTable::bytes() const {
    return sizeof(*this) + leaves_.capacity() * sizeof(Leaf) +
           directory_.capacity() * sizeof(std::uint32_t) + tiles_.capacity() * sizeof(Tile);
}

void LeafTable::frame_directory() {
    constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
    Cell low{kFar, kFar};
    Cell high{-kFar, -kFar};
    bool any = false;
    for (const Leaf& leaf : leaves_) {
        if (!is_aligned_inside(leaf, root_)) {
            throw std::logic_error("LeafTable: a leaf is not an aligned block inside the root");
        }
        if (leaf.state == CellState::unknown) continue;
        any = true;
        const std::int32_t reach = leaf.side_cells() - 1;
        low = {std::min(low.x, leaf.lower_left.x), std::min(low.y, leaf.lower_left.y)};
        high = {std::max(high.x, leaf.lower_left.x + reach),
                std::max(high.y, leaf.lower_left.y + reach)};
    }
    if (!any) return;
    low_tile_ = {low.x >> kTileBits, low.y >> kTileBits};
    width_ = (high.x >> kTileBits) - low_tile_.x + 1;
    height_ = (high.y >> kTileBits) - low_tile_.y + 1;
    if (std::int64_t{width_} * height_ > kMaxTiles) {
        throw std::logic_error("LeafTable: the leaves lie too far apart");
    }
    directory_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                      kNothing);
}

void LeafTable::add_large_leaf(std::uint32_t id) {
    const Leaf& leaf = leaves_[id];
    const std::int32_t side = leaf.side_cells() >> kTileBits;
    const std::int32_t x = (leaf.lower_left.x >> kTileBits) - low_tile_.x;
    const std::int32_t y = (leaf.lower_left.y >> kTileBits) - low_tile_.y;
    for (std::int32_t row = y; row < y + side; ++row) {
        const auto begin = directory_.begin() + std::ptrdiff_t{row} * width_ + x;
        if (std::any_of(begin, begin + side, [](std::uint32_t e) { return e != kNothing; })) {
            throw std::logic_error("LeafTable: leaves overlap");
        }
        std::fill(begin, begin + side, id);
    }
}

void LeafTable::add_small_leaf(std::uint32_t id) {
    const Leaf& leaf = leaves_[id];
    const std::int32_t x = (leaf.lower_left.x >> kTileBits) - low_tile_.x;
    const std::int32_t y = (leaf.lower_left.y >> kTileBits) - low_tile_.y;
    std::uint32_t& entry =
        directory_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
    if (entry == kNothing) {
        entry = kMixed | static_cast<std::uint32_t>(tiles_.size());
        tiles_.push_back({id, 0, {}});
        tiles_.back().offsets.fill(kNoLeaf);
    } else if ((entry & kMixed) == 0) {
        throw std::logic_error("LeafTable: leaves overlap");
    }
    Tile& tile = tiles_[entry & ~kMixed];
    // In depth-first order the leaves of a tile follow each other, and there are 64 at most.
    if (id - tile.first_leaf >= kTileCells) {
        throw std::logic_error("LeafTable: leaves are not in depth-first order");
    }
    const std::size_t corner = cell_in_tile(leaf.lower_left);
    const auto side = static_cast<std::size_t>(leaf.side_cells());
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; ++column) {
            std::uint8_t& offset = tile.offsets[corner + row * kTileSide + column];
            if (offset != kNoLeaf) throw std::logic_error("LeafTable: leaves overlap");
            offset = static_cast<std::uint8_t>(id - tile.first_leaf);
        }
    }
    tile.num_leaves = id - tile.first_leaf + 1;
}

}  // namespace quadcut
