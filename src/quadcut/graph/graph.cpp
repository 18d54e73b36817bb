// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/graph/graph.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace quadcut {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Sorts each row by column and adds up entries of the same column.
void sort_and_merge_rows(Graph& graph) {
    std::vector<std::pair<std::uint32_t, double>> row;
    std::size_t out = 0;
    for (std::size_t node = 0; node < graph.num_nodes(); ++node) {
        row.clear();
        for (std::size_t k = graph.row_begin[node]; k < graph.row_begin[node + 1]; ++k) {
            row.emplace_back(graph.columns[k], graph.weights[k]);
        }
        std::stable_sort(row.begin(), row.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        const std::size_t first = out;
        for (const auto& [column, weight] : row) {
            if (out > first && graph.columns[out - 1] == column) {
                graph.weights[out - 1] += weight;
            } else {
                graph.columns[out] = column;
                graph.weights[out] = weight;
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
    sort_and_merge_rows(graph);
    return graph;
}

Graph induced_subgraph(const Graph& graph, std::span<const std::uint32_t> nodes) {
    std::vector<std::uint32_t> new_index(graph.num_nodes(), kNone);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        new_index[nodes[i]] = static_cast<std::uint32_t>(i);
    }
    Graph sub;
    for (const std::uint32_t node : nodes) {
        const auto columns = graph.neighbours(node);
        const auto weights = graph.neighbour_weights(node);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (new_index[columns[k]] == kNone) continue;
            sub.columns.push_back(new_index[columns[k]]);
            sub.weights.push_back(weights[k]);
        }
        sub.row_begin.push_back(sub.columns.size());
        sub.area_m2.push_back(graph.area_m2[node]);
    }
    return sub;
}

std::vector<std::uint32_t> connected_components(const Graph& graph) {
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
                component[next] = num_components;
                stack.push_back(next);
            }
        }
        ++num_components;
    }
    return component;
}

}  // namespace quadcut
