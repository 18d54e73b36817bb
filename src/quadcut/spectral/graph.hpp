// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadcut {

/// An undirected edge on its way into a Graph; each pair once, either way round. a == b is a
/// self-loop.
struct WeightedEdge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double weight = 0.0;
};

/// A weighted undirected graph in compressed sparse rows: the neighbours of node i are
/// columns[row_begin[i] .. row_begin[i + 1]), ascending, with their weights. Symmetric: (i, j) and
/// (j, i) are both stored; a self-loop is stored once. Nodes carry the area they stand for.
struct Graph {
    std::vector<std::size_t> row_begin{0};
    std::vector<std::uint32_t> columns;
    std::vector<double> weights;
    std::vector<double> area_m2;

    [[nodiscard]] std::size_t num_nodes() const { return row_begin.size() - 1; }
    [[nodiscard]] std::span<const std::uint32_t> neighbours(std::size_t node) const {
        return std::span(columns).subspan(row_begin[node], row_begin[node + 1] - row_begin[node]);
    }
    [[nodiscard]] std::span<const double> neighbour_weights(std::size_t node) const {
        return std::span(weights).subspan(row_begin[node], row_begin[node + 1] - row_begin[node]);
    }
};

/// Builds the graph of `edges` over area_m2.size() nodes. Edges of the same pair are added up.
/// O(nodes + edges). Throws std::logic_error if an edge names a node that does not exist.
[[nodiscard]] Graph build_graph(std::span<const WeightedEdge> edges, std::vector<double> area_m2);

/// The graph that `nodes` (ascending, without repeats) induce; node i of the result is nodes[i].
/// O(rows of those nodes + last node - first node). Throws std::logic_error if they are not so.
[[nodiscard]] Graph induced_subgraph(const Graph& graph, std::span<const std::uint32_t> nodes);

/// The connected component of each node, numbered from 0 by first node. With `labels` (one a node),
/// edges between different labels do not connect. O(nodes + edges).
[[nodiscard]] std::vector<std::uint32_t> connected_components(
    const Graph& graph, std::span<const std::uint32_t> labels = {});

/// The number of a graph's edges, without loops.
[[nodiscard]] std::size_t num_edges(const Graph& graph);

}  // namespace quadcut
