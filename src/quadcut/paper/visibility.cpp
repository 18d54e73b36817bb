// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/visibility.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "quadcut/paper/line_of_sight.hpp"
#include "quadcut/spectral/accelerator.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kNodesPerChunk = 512;
constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();

void require_region(const LeafTable& table, std::span<const LeafId> nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool ascends = i == 0 || nodes[i - 1] < nodes[i];
        if (!ascends || index(nodes[i]) >= table.leaves().size() ||
            table.leaf(nodes[i]).state != CellState::free) {
            throw std::logic_error("sight_edges: nodes must be free leaves, ascending");
        }
    }
}

/// The node of each leaf from the first node's to the last one's; kNoNode where it is none.
std::vector<std::uint32_t> nodes_by_leaf(std::span<const LeafId> nodes) {
    const std::size_t first = index(nodes.front());
    std::vector<std::uint32_t> node_of(index(nodes.back()) - first + 1, kNoNode);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) node_of[index(nodes[i]) - first] = i;
    return node_of;
}

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
struct SightRow {
    const LeafTable& table;
    const BlockedCells& blocked;
    double resolution_m;
    std::size_t first_leaf;
    std::vector<std::uint32_t> node_of;

    void append(std::uint32_t node, LeafId id, std::vector<WeightedEdge>& edges) const {
        const Leaf& leaf = table.leaf(id);
        const std::int32_t side = leaf.side_cells();
        // Equal leaves lie on a grid of their size, where eq. (3) reaches those that are one side,
        // sqrt 2 and two sides away.
        for (std::int32_t up = -2; up <= 2; ++up) {
            const std::int32_t most = 2 - std::abs(up);
            for (std::int32_t right = -most; right <= most; ++right) {
                const std::optional<LeafId> other =
                    table.find({leaf.lower_left.x + right * side, leaf.lower_left.y + up * side});
                if (other.has_value() && *other > id && table.leaf(*other).level == leaf.level) {
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
        table.for_each_leaf_in(cell(middle.x - reach - 1, middle.y - reach - 1),
                               cell(middle.x + reach, middle.y + reach), [&](LeafId other) {
                                   if (table.leaf(other).level < leaf.level) {
                                       append_if_seen(node, leaf, other, edges);
                                   }
                               });
    }

    void append_if_seen(std::uint32_t node, const Leaf& leaf, LeafId other_id,
                        std::vector<WeightedEdge>& edges) const {
        const Leaf& other = table.leaf(other_id);
        if (!is_within_threshold(leaf, other)) return;
        const std::size_t place = index(other_id) - first_leaf;
        if (place >= node_of.size() || node_of[place] == kNoNode) return;
        const std::int32_t side = leaf.side_cells();
        const std::int32_t other_side = other.side_cells();
        if (!blocked.sees(centre(leaf), centre(other), side, other_side)) return;
        edges.push_back(
            {node, node_of[place], sight_weight(side * resolution_m, other_side * resolution_m)});
    }
};

/// One after the other; each is given back once it is copied.
std::vector<WeightedEdge> joined(std::vector<std::vector<WeightedEdge>> chunks) {
    std::vector<WeightedEdge> all;
    std::size_t num_edges = 0;
    for (const std::vector<WeightedEdge>& chunk : chunks) num_edges += chunk.size();
    all.reserve(num_edges);
    for (std::vector<WeightedEdge>& chunk : chunks) {
        all.insert(all.end(), chunk.begin(), chunk.end());
        std::vector<WeightedEdge>().swap(chunk);
    }
    return all;
}

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
    require_region(table, nodes);
    if (nodes.empty()) return {};
    if (executor.accelerator != nullptr) {
        auto edges = executor.accelerator->sight_edges(table, nodes, resolution_m, self_loops);
        if (edges.has_value()) return std::move(*edges);
    }
    const Box box = bounding_box(table, nodes);
    const BlockedCells blocked(table, box.low, box.high);
    const SightRow row{table, blocked, resolution_m, index(nodes.front()), nodes_by_leaf(nodes)};

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

    std::vector<std::vector<WeightedEdge>> chunks((nodes.size() + kNodesPerChunk - 1) /
                                                  kNodesPerChunk);
    parallel_for(executor, nodes.size(), kNodesPerChunk, [&](std::size_t first, std::size_t last) {
        std::vector<WeightedEdge>& edges = chunks[first / kNodesPerChunk];
        for (std::size_t i = first; i < last; ++i) {
            const auto begin = static_cast<std::ptrdiff_t>(edges.size());
            const auto node = static_cast<std::uint32_t>(i);
            if (self_loops != SelfLoops::none) {
                edges.push_back({node, node, loop_weight(nodes[i])});
            }
            row.append(node, nodes[i], edges);
            std::sort(edges.begin() + begin, edges.end(),
                      [](const WeightedEdge& a, const WeightedEdge& b) { return a.b < b.b; });
        }
    });
    return joined(std::move(chunks));
}

}  // namespace quadcut
