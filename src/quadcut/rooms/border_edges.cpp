// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/border_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "quadcut/map/leaf.hpp"
#include "quadcut/map/node_index.hpp"
#include "quadcut/spectral/edge_rows.hpp"

namespace quadcut {
namespace {

/// Of two squares side by side in a quadtree one spans the other's side, so what they share is the
/// smaller side.
double border_weight(const Leaf& leaf, const Leaf& other) {
    const HalfCell a = centre(leaf);
    const HalfCell b = centre(other);
    const double shared = std::min(leaf.side_cells(), other.side_cells());
    const auto dx = static_cast<double>(a.x - b.x);
    const auto dy = static_cast<double>(a.y - b.y);
    return 2.0 * shared / std::sqrt(dx * dx + dy * dy);
}

/// Calls `visit(LeafId)` for each leaf that holds one of `count` cells from `first` on, in order.
/// `step` is (1, 0) or (0, 1). The cells are those beyond one side of a leaf, so that a leaf among
/// them begins where it is met, or is as long as all of them.
template <typename Visitor>
void for_each_leaf_along(const LeafTable& table, Cell first, Cell step, std::int32_t count,
                         const Visitor& visit) {
    for (std::int32_t i = 0; i < count;) {
        const std::optional<LeafId> id = table.find({first.x + i * step.x, first.y + i * step.y});
        if (!id.has_value()) {
            ++i;
            continue;
        }
        visit(*id);
        i += table.leaf(*id).side_cells();
    }
}

}  // namespace

std::vector<WeightedEdge> border_edges(const LeafTable& table, std::span<const LeafId> nodes,
                                       const Executor& executor) {
    const NodeIndex index(table, nodes);
    return collect_edge_rows(
        nodes.size(), executor, [&](std::uint32_t node, std::vector<WeightedEdge>& edges) {
            const Leaf& leaf = table.leaf(nodes[node]);
            const std::int32_t side = leaf.side_cells();
            const Cell low = leaf.lower_left;
            const auto append = [&](LeafId other) {
                const std::optional<std::uint32_t> other_node = index.find(other);
                if (!other_node.has_value()) return;
                edges.push_back({node, *other_node, border_weight(leaf, table.leaf(other))});
            };
            // The cells just beyond the right side, and just beyond the top.
            for_each_leaf_along(table, {low.x + side, low.y}, {0, 1}, side, append);
            for_each_leaf_along(table, {low.x, low.y + side}, {1, 0}, side, append);
        });
}

}  // namespace quadcut
