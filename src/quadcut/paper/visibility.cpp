// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/visibility.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "quadcut/map/node_index.hpp"
#include "quadcut/paper/line_of_sight.hpp"
#include "quadcut/spectral/accelerator.hpp"
#include "quadcut/spectral/edge_rows.hpp"

namespace quadcut {
namespace {

Box bounding_box(const LeafTable& table, std::span<const LeafId> nodes) {
    Box box;
    for (const LeafId id : nodes) box.include(table.leaf(id).box());
    return box;
}

bool is_within_threshold(const Leaf& i, const Leaf& j) {
    const HalfCell a = centre(i);
    const HalfCell b = centre(j);
    const std::int64_t sides = 2 * (std::int64_t{i.side_cells()} + j.side_cells());
    const std::int64_t distance2 = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
    // Eq. (3): Th_ij = 1.05 (s_i + s_j), both sides squared and times 20^2 to stay in integers.
    return 400 * distance2 <= 441 * sides * sides;
}

/// The row of one node: its edges to finer leaves, and to equal ones that come later (rule 2).
class SightRow {
public:
    SightRow(const LeafTable& table, const NodeIndex& index, const BlockedCells& blocked,
             double resolution_m)
        : table_(table), index_(index), blocked_(blocked), resolution_m_(resolution_m) {}

    void append(std::uint32_t node, LeafId id, std::vector<WeightedEdge>& edges) const {
        const Leaf& leaf = table_.leaf(id);
        const std::int32_t side = leaf.side_cells();
        // Equal leaves lie on a grid of their size, where eq. (3) reaches those that are one side,
        // sqrt 2 and two sides away.
        for (std::int32_t up = -2; up <= 2; ++up) {
            const std::int32_t most = 2 - std::abs(up);
            for (std::int32_t right = -most; right <= most; ++right) {
                const std::optional<LeafId> other =
                    table_.find({leaf.lower_left.x + right * side, leaf.lower_left.y + up * side});
                if (other.has_value() && *other > id && table_.leaf(*other).level == leaf.level) {
                    append_if_seen(node, leaf, *other, edges);
                }
            }
        }
        if (leaf.level == 0) return;
        // Rule 3 looks 2.1 sides far; finer leaves need less. One within Th begins at most 1.05 s_i
        // and 0.55 s_j from the centre along either axis, and at a multiple of s_j: at 17/16 s_i or
        // before, for each s_j = s_i / 2, s_i / 4, ... In half cells:
        const HalfCell middle = centre(leaf);
        const std::int64_t reach = 17 * std::int64_t{side} / 8;
        const auto cell = [](std::int64_t x, std::int64_t y) {
            return Cell{static_cast<std::int32_t>(x >> 1), static_cast<std::int32_t>(y >> 1)};
        };
        table_.for_each_leaf_in(cell(middle.x - reach - 1, middle.y - reach - 1),
                                cell(middle.x + reach, middle.y + reach), [&](LeafId other) {
                                    if (table_.leaf(other).level < leaf.level) {
                                        append_if_seen(node, leaf, other, edges);
                                    }
                                });
    }

private:
    void append_if_seen(std::uint32_t node, const Leaf& leaf, LeafId other_id,
                        std::vector<WeightedEdge>& edges) const {
        const Leaf& other = table_.leaf(other_id);
        if (!is_within_threshold(leaf, other)) return;
        const std::optional<std::uint32_t> other_node = index_.find(other_id);
        if (!other_node.has_value()) return;
        const std::int32_t side = leaf.side_cells();
        const std::int32_t other_side = other.side_cells();
        if (!blocked_.sees(centre(leaf), centre(other), side, other_side)) return;
        edges.push_back(
            {node, *other_node, sight_weight(side * resolution_m_, other_side * resolution_m_)});
    }

    const LeafTable& table_;
    const NodeIndex& index_;
    const BlockedCells& blocked_;
    double resolution_m_;
};

}  // namespace

double sight_weight(double side_i_m, double side_j_m) {
    // Eq. (2): w_ij = 1 / (eta (2^l_i + 2^l_j)). With eta = 1 / max(x_map, y_map) and a cell of
    // layer l of side s = max(x_map, y_map) / 2^l this is w_ij = s_i s_j / (s_i + s_j), metres,
    // whatever the size of the root.
    return side_i_m * side_j_m / (side_i_m + side_j_m);
}

std::vector<WeightedEdge> sight_edges(const LeafTable& table, std::span<const LeafId> nodes,
                                      double resolution_m, SelfLoops self_loops,
                                      const Executor& executor) {
    const NodeIndex index(table, nodes);
    if (nodes.empty()) return {};
    if (executor.accelerator != nullptr) {
        auto edges = executor.accelerator->sight_edges(table, nodes, resolution_m, self_loops);
        if (edges.has_value()) return std::move(*edges);
    }
    const Box box = bounding_box(table, nodes);
    const BlockedCells blocked(table, box.low, box.high);
    const SightRow row(table, index, blocked, resolution_m);

    std::int32_t largest_side = 0;
    for (const LeafId id : nodes) {
        largest_side = std::max(largest_side, table.leaf(id).side_cells());
    }
    const auto loop_weight = [&](LeafId id) {
        const double side_m =
            resolution_m *
            (self_loops == SelfLoops::own_weight ? table.leaf(id).side_cells() : largest_side);
        return sight_weight(side_m, side_m);
    };

    return collect_edge_rows(nodes.size(), executor,
                             [&](std::uint32_t node, std::vector<WeightedEdge>& edges) {
                                 if (self_loops != SelfLoops::none) {
                                     edges.push_back({node, node, loop_weight(nodes[node])});
                                 }
                                 row.append(node, nodes[node], edges);
                             });
}

}  // namespace quadcut
