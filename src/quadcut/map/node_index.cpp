// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/node_index.hpp"

#include <stdexcept>

namespace quadcut {

NodeIndex::NodeIndex(const LeafTable& table, std::span<const LeafId> nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i > 0 && nodes[i] <= nodes[i - 1]) {
            throw std::logic_error("NodeIndex: the leaves of a region must ascend");
        }
        if (index(nodes[i]) >= table.leaves().size() ||
            table.leaf(nodes[i]).state != CellState::free) {
            throw std::logic_error("NodeIndex: a node of the graph must be a free leaf");
        }
    }
    if (nodes.empty()) return;
    first_ = index(nodes.front());
    blocks_.resize((index(nodes.back()) - first_) / 64 + 1);
    for (const LeafId id : nodes) {
        const std::size_t bit = index(id) - first_;
        blocks_[bit / 64].present |= std::uint64_t{1} << (bit % 64);
    }
    std::uint32_t before = 0;
    for (Block& block : blocks_) {
        block.before = before;
        before += static_cast<std::uint32_t>(std::popcount(block.present));
    }
}

}  // namespace quadcut
