// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/line_of_sight.hpp"
#include "quadcut/paper/visibility.hpp"

// The paper's parallel construction of the graph (its Fig 7), as a baseline: a queue of all pairs
// of nodes within reach, in n parts; each process gets a deep copy of the quadtree and its part,
// drops the pairs without relevance, and the rest is put together. Threads stand for processes:
// they copy as much and start faster.
namespace quadcut {

using NodePair = std::pair<std::uint32_t, std::uint32_t>;

inline bool is_in_reach(const Leaf& i, const Leaf& j) {
    const HalfCell a = centre(i);
    const HalfCell b = centre(j);
    const std::int64_t sides = 2 * (std::int64_t{i.side_cells()} + j.side_cells());
    const std::int64_t squared = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
    return 400 * squared <= 441 * sides * sides;
}

/// Each pair once, from the coarser leaf: rules 2 and 3.
inline std::vector<NodePair> queue_of_pairs(const FreeLeaves& leaves) {
    const auto& all = leaves.table.leaves();
    std::vector<std::uint32_t> node_of(all.size(), 0xffffffff);
    for (std::uint32_t i = 0; i < leaves.nodes.size(); ++i) node_of[index(leaves.nodes[i])] = i;
    std::vector<NodePair> queue;
    for (std::uint32_t i = 0; i < leaves.nodes.size(); ++i) {
        const LeafId id = leaves.nodes[i];
        const Leaf& leaf = leaves.table.leaf(id);
        const Box reach = leaf.box().grown(3 * leaf.side_cells());
        leaves.table.for_each_leaf_in(reach.low, reach.high, [&](LeafId other) {
            const Leaf& beside = leaves.table.leaf(other);
            const bool is_later = beside.level < leaf.level ||
                                  (beside.level == leaf.level && index(other) > index(id));
            if (!is_later || node_of[index(other)] == 0xffffffff) return;
            if (is_in_reach(leaf, beside)) queue.emplace_back(i, node_of[index(other)]);
        });
    }
    return queue;
}

/// The pairs of one part that see each other, by a tree of its own.
inline std::vector<WeightedEdge> relevant_pairs(const FreeLeaves& shared,
                                                const std::vector<NodePair>& part,
                                                double resolution_m) {
    const auto copy = std::make_unique<FreeLeaves>(shared);
    Box box;
    for (const LeafId id : copy->nodes) box.include(copy->table.leaf(id).box());
    const BlockedCells blocked(copy->table, box.low, box.high);
    std::vector<WeightedEdge> edges;
    for (const auto& [a, b] : part) {
        const Leaf& i = copy->table.leaf(copy->nodes[a]);
        const Leaf& j = copy->table.leaf(copy->nodes[b]);
        if (!blocked.sees(centre(i), centre(j), i.side_cells(), j.side_cells())) continue;
        edges.push_back(
            {a, b, sight_weight(i.side_cells() * resolution_m, j.side_cells() * resolution_m)});
    }
    return edges;
}

/// Steps 4 to 7 of the paper's parallel algorithm, without self-loops.
inline std::vector<WeightedEdge> edges_by_queue(const FreeLeaves& leaves, double resolution_m,
                                                std::size_t num_parts) {
    const std::vector<NodePair> queue = queue_of_pairs(leaves);
    std::vector<std::vector<WeightedEdge>> found(num_parts);
    std::vector<std::thread> processes;
    for (std::size_t part = 0; part < num_parts; ++part) {
        const auto begin = static_cast<std::ptrdiff_t>(queue.size() * part / num_parts);
        const auto end = static_cast<std::ptrdiff_t>(queue.size() * (part + 1) / num_parts);
        processes.emplace_back([&, part, begin, end] {
            found[part] =
                relevant_pairs(leaves, {queue.begin() + begin, queue.begin() + end}, resolution_m);
        });
    }
    for (std::thread& process : processes) process.join();
    std::vector<WeightedEdge> edges;
    for (const auto& part : found) edges.insert(edges.end(), part.begin(), part.end());
    return edges;
}

}  // namespace quadcut
