// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/graph.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace quadcut {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Sorts each row by column without comparing: when the rows are dealt out to their columns in
/// ascending order, each column of a symmetric matrix receives its rows sorted, and equal ones in
/// the order they had.
void sort_rows(Graph& graph) {
    std::vector<std::uint32_t> columns(graph.columns.size());
    std::vector<double> weights(graph.weights.size());
    std::vector<std::size_t> next(graph.row_begin.begin(), graph.row_begin.end() - 1);
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        for (std::size_t k = graph.row_begin[node]; k < graph.row_begin[node + 1]; ++k) {
            const std::size_t slot = next[graph.columns[k]]++;
            columns[slot] = node;
            weights[slot] = graph.weights[k];
        }
    }
    graph.columns = std::move(columns);
    graph.weights = std::move(weights);
}

/// Adds up entries of the same column, which follow each other.
void merge_equal_columns(Graph& graph) {
    std::size_t out = 0;
    for (std::size_t node = 0; node < graph.num_nodes(); ++node) {
        const std::size_t first = out;
        for (std::size_t k = graph.row_begin[node]; k < graph.row_begin[node + 1]; ++k) {
            if (out > first && graph.columns[out - 1] == graph.columns[k]) {
                graph.weights[out - 1] += graph.weights[k];
            } else {
                graph.columns[out] = graph.columns[k];
                graph.weights[out] = graph.weights[k];
                ++out;
            }
        }
        graph.row_begin[node] = first;
    }
    graph.row_begin.back() = out;
    graph.columns.resize(out);
    graph.weights.resize(out);
}

}  // namespace

Graph build_graph(std::span<const WeightedEdge> edges, std::vector<double> area_m2) {
    Graph graph;
    const std::size_t num_nodes = area_m2.size();
    graph.area_m2 = std::move(area_m2);
    graph.row_begin.assign(num_nodes + 1, 0);
    for (const WeightedEdge& edge : edges) {
        if (edge.a >= num_nodes || edge.b >= num_nodes) {
            throw std::logic_error("build_graph: an edge names a node that does not exist");
        }
        ++graph.row_begin[edge.a + 1];
        if (edge.a != edge.b) ++graph.row_begin[edge.b + 1];
    }
    for (std::size_t i = 0; i < num_nodes; ++i) graph.row_begin[i + 1] += graph.row_begin[i];
    graph.columns.resize(graph.row_begin.back());
    graph.weights.resize(graph.row_begin.back());
    std::vector<std::size_t> next(graph.row_begin.begin(), graph.row_begin.end() - 1);
    const auto put = [&](std::uint32_t from, std::uint32_t to, double weight) {
        graph.columns[next[from]] = to;
        graph.weights[next[from]++] = weight;
    };
    for (const WeightedEdge& edge : edges) {
        put(edge.a, edge.b, edge.weight);
        if (edge.a != edge.b) put(edge.b, edge.a, edge.weight);
    }
    sort_rows(graph);
    merge_equal_columns(graph);
    return graph;
}

Graph induced_subgraph(const Graph& graph, std::span<const std::uint32_t> nodes) {
    Graph sub;
    if (nodes.empty()) return sub;
    if (std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal<>()) != nodes.end() ||
        nodes.back() >= graph.num_nodes()) {
        throw std::logic_error("induced_subgraph: the nodes must exist and ascend");
    }
    // Only as wide as the nodes are apart: a graph falls into many small components.
    const std::uint32_t first = nodes.front();
    std::vector<std::uint32_t> new_index(std::size_t{nodes.back()} - first + 1, kNone);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        new_index[nodes[i] - first] = static_cast<std::uint32_t>(i);
    }
    for (const std::uint32_t node : nodes) {
        const auto columns = graph.neighbours(node);
        const auto weights = graph.neighbour_weights(node);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const std::size_t place = std::size_t{columns[k]} - first;
            if (columns[k] < first || place >= new_index.size() || new_index[place] == kNone) {
                continue;
            }
            sub.columns.push_back(new_index[place]);
            sub.weights.push_back(weights[k]);
        }
        sub.row_begin.push_back(sub.columns.size());
        sub.area_m2.push_back(graph.area_m2[node]);
    }
    return sub;
}

std::vector<std::uint32_t> connected_components(const Graph& graph,
                                                std::span<const std::uint32_t> labels) {
    std::vector<std::uint32_t> component(graph.num_nodes(), kNone);
    std::vector<std::uint32_t> stack;
    std::uint32_t num_components = 0;
    for (std::uint32_t seed = 0; seed < graph.num_nodes(); ++seed) {
        if (component[seed] != kNone) continue;
        component[seed] = num_components;
        stack.push_back(seed);
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            for (const std::uint32_t next : graph.neighbours(node)) {
                if (component[next] != kNone) continue;
                if (!labels.empty() && labels[next] != labels[node]) continue;
                component[next] = num_components;
                stack.push_back(next);
            }
        }
        ++num_components;
    }
    return component;
}

// Each edge stands in two rows.
std::size_t num_edges(const Graph& graph) {
    std::size_t num_entries = 0;
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        for (const std::uint32_t next : graph.neighbours(node)) {
            if (next != node) ++num_entries;
        }
    }
    return num_entries / 2;
}

}  // namespace quadcut
