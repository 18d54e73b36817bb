// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "quadcut/map/root.hpp"

namespace quadcut {

/// A node for every block, four children allocated together; blocks of one value collapse at once.
class PointerQuadtree {
public:
    explicit PointerQuadtree(const Root& root) : root_(root) {}

    [[nodiscard]] int log_odds(Cell cell) const {
        const Cell at{cell.x - root_.lower_left.x, cell.y - root_.lower_left.y};
        const std::int32_t side = root_.side_cells();
        if (at.x < 0 || at.y < 0 || at.x >= side || at.y >= side) return 0;
        const Node* node = &top_;
        for (int level = root_.level - 1; node->children; --level) {
            node = &node->children[child(at, level)];
        }
        return node->value;
    }
    void set(Cell cell, int log_odds) {
        set(top_, {cell.x - root_.lower_left.x, cell.y - root_.lower_left.y}, root_.level,
            static_cast<std::int8_t>(log_odds));
    }
    /// Leaves and inner nodes.
    [[nodiscard]] std::size_t num_nodes() const { return 1 + 4 * num_inner_; }
    /// Bytes that the nodes ask for, without what the allocator adds.
    [[nodiscard]] std::size_t bytes() const { return sizeof(Node) * num_nodes(); }

private:
    struct Node {
        std::unique_ptr<Node[]> children;
        std::int8_t value = 0;
    };

    static std::size_t child(Cell at, int level) {
        return static_cast<std::size_t>((at.x >> level & 1) | (at.y >> level & 1) << 1);
    }
    void set(Node& node, Cell at, int level, std::int8_t value) {
        if (level == 0) {
            node.value = value;
            return;
        }
        if (!node.children) {
            if (node.value == value) return;
            node.children = std::make_unique<Node[]>(4);
            for (std::size_t i = 0; i < 4; ++i) node.children[i].value = node.value;
            ++num_inner_;
        }
        set(node.children[child(at, level - 1)], at, level - 1, value);
        for (std::size_t i = 0; i < 4; ++i) {
            if (node.children[i].children || node.children[i].value != value) return;
        }
        node.children.reset();
        node.value = value;
        --num_inner_;
    }

    Root root_;
    Node top_;
    std::size_t num_inner_ = 0;
};

}  // namespace quadcut
