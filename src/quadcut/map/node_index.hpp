// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadcut/base/ids.hpp"
#include "quadcut/map/leaf_table.hpp"

namespace quadcut {

/// The node number of each leaf of a region: the position of the leaf in the region's list. A bit a
/// leaf and a running count every 64 of them, so that a small region of a large map stays cheap.
class NodeIndex {
public:
    /// O(nodes + (last id - first id) / 64). Throws std::logic_error unless `nodes` are free leaves
    /// of the table, ascending, without repeats.
    NodeIndex(const LeafTable& table, std::span<const LeafId> nodes);

    /// The node of a leaf, or nothing when the leaf is not in the region. O(1).
    [[nodiscard]] std::optional<std::uint32_t> find(LeafId id) const {
        const std::size_t bit = index(id) - first_;
        if (index(id) < first_ || bit / 64 >= blocks_.size()) return std::nullopt;
        const Block& block = blocks_[bit / 64];
        const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
        if ((block.present & mask) == 0) return std::nullopt;
        return block.before + static_cast<std::uint32_t>(std::popcount(block.present & (mask - 1)));
    }

private:
    struct Block {
        std::uint64_t present = 0;
        std::uint32_t before = 0;
    };

    std::size_t first_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace quadcut
