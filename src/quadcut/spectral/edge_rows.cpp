// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/edge_rows.hpp"

#include <algorithm>

namespace quadcut {
namespace {

constexpr std::size_t kNodesPerChunk = 512;

}  // namespace

std::vector<WeightedEdge> collect_edge_rows(
    std::size_t num_nodes, const Executor& executor,
    const std::function<void(std::uint32_t node, std::vector<WeightedEdge>& edges)>& append) {
    std::vector<std::vector<WeightedEdge>> chunks((num_nodes + kNodesPerChunk - 1) /
                                                  kNodesPerChunk);
    parallel_for(executor, num_nodes, kNodesPerChunk, [&](std::size_t first, std::size_t last) {
        std::vector<WeightedEdge>& edges = chunks[first / kNodesPerChunk];
        for (std::size_t node = first; node < last; ++node) {
            const auto begin = static_cast<std::ptrdiff_t>(edges.size());
            append(static_cast<std::uint32_t>(node), edges);
            std::sort(edges.begin() + begin, edges.end(),
                      [](const WeightedEdge& a, const WeightedEdge& b) { return a.b < b.b; });
        }
    });
    std::vector<WeightedEdge> joined;
    std::size_t num_edges = 0;
    for (const std::vector<WeightedEdge>& chunk : chunks) num_edges += chunk.size();
    joined.reserve(num_edges);
    for (std::vector<WeightedEdge>& chunk : chunks) {
        joined.insert(joined.end(), chunk.begin(), chunk.end());
        std::vector<WeightedEdge>().swap(chunk);
    }
    return joined;
}

}  // namespace quadcut
