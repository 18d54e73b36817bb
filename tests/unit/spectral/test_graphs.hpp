// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut::test {

inline std::uint32_t node_id(std::size_t i) { return static_cast<std::uint32_t>(i); }

/// Nodes in a row, edges of weight 1.
inline Graph path_graph(std::size_t num_nodes) {
    std::vector<WeightedEdge> edges;
    for (std::size_t i = 0; i + 1 < num_nodes; ++i) {
        edges.push_back({node_id(i), node_id(i + 1), 1.0});
    }
    return build_graph(edges, std::vector<double>(num_nodes, 1.0));
}

/// One centre, node 0, and leaves.
inline Graph star_graph(std::size_t num_leaves) {
    std::vector<WeightedEdge> edges;
    for (std::size_t i = 1; i <= num_leaves; ++i) edges.push_back({0, node_id(i), 1.0});
    return build_graph(edges, std::vector<double>(num_leaves + 1, 1.0));
}

/// A floor plan as text: '#' is wall, everything else a cell of area `area_m2`; cells that share a
/// side have an edge of weight 1.
inline Graph floor_graph(const std::vector<std::string>& rows, double area_m2 = 1.0) {
    std::vector<std::vector<int>> id(rows.size());
    std::size_t num_nodes = 0;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        for (const char c : rows[y]) id[y].push_back(c == '#' ? -1 : static_cast<int>(num_nodes++));
    }
    std::vector<WeightedEdge> edges;
    const auto add = [&](int a, int b) {
        if (a < 0 || b < 0) return;
        edges.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), 1.0});
    };
    for (std::size_t y = 0; y < rows.size(); ++y) {
        for (std::size_t x = 0; x < id[y].size(); ++x) {
            if (x + 1 < id[y].size()) add(id[y][x], id[y][x + 1]);
            if (y + 1 < rows.size() && x < id[y + 1].size()) add(id[y][x], id[y + 1][x]);
        }
    }
    return build_graph(edges, std::vector<double>(num_nodes, area_m2));
}

/// A rectangle of cells without walls.
inline Graph grid_graph(std::size_t width, std::size_t height, double area_m2 = 1.0) {
    return floor_graph(std::vector<std::string>(height, std::string(width, '.')), area_m2);
}

/// Square rooms of `side` cells in rows of `per_row`, with walls between them; `doors`: an opening
/// in the middle of each wall, or none.
enum class Doors : std::uint8_t { none, open };
inline std::vector<std::string> room_plan(std::size_t per_row, std::size_t num_rows,
                                          std::size_t side, Doors doors) {
    const std::size_t step = side + 1;
    std::vector<std::string> plan(num_rows * step + 1, std::string(per_row * step + 1, '#'));
    for (std::size_t y = 0; y < plan.size(); ++y) {
        for (std::size_t x = 0; x < plan[y].size(); ++x) {
            const bool wall_x = x % step == 0;
            const bool wall_y = y % step == 0;
            const bool border = x == 0 || y == 0 || x + 1 == plan[y].size() || y + 1 == plan.size();
            const bool door =
                doors == Doors::open && !border &&
                ((wall_x && y % step == step / 2) || (wall_y && x % step == step / 2));
            if ((!wall_x && !wall_y) || door) plan[y][x] = '.';
        }
    }
    return plan;
}

/// Random weights (over four decades), areas and some loops; connected by a random tree, unless
/// `num_groups` > 1: then nodes of different groups (node % num_groups) have no edge.
inline Graph random_graph(Random& random, std::size_t num_nodes, double edges_per_node,
                          std::size_t num_groups = 1) {
    std::vector<WeightedEdge> edges;
    const auto weight = [&] { return std::pow(10.0, random.uniform(-2.0, 2.0)); };
    for (std::size_t i = num_groups; i < num_nodes; ++i) {
        // An earlier node of the same group.
        const std::size_t earlier = random.below(i / num_groups) * num_groups + i % num_groups;
        edges.push_back({node_id(earlier), node_id(i), weight()});
    }
    const auto more = static_cast<std::size_t>(edges_per_node * static_cast<double>(num_nodes));
    for (std::size_t e = 0; e < more; ++e) {
        const std::size_t a = random.below(num_nodes);
        const std::size_t b = random.below(num_nodes);
        if (a % num_groups == b % num_groups) edges.push_back({node_id(a), node_id(b), weight()});
    }
    std::vector<double> area_m2(num_nodes);
    for (double& area : area_m2) area = std::pow(4.0, random.uniform(-3.0, 1.0));
    return build_graph(edges, std::move(area_m2));
}

/// The same graph with node i renamed to new_id[i].
inline Graph renamed(const Graph& graph, const std::vector<std::uint32_t>& new_id) {
    std::vector<WeightedEdge> edges;
    std::vector<double> area_m2(graph.num_nodes());
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        area_m2[new_id[i]] = graph.area_m2[i];
        const auto columns = graph.neighbours(i);
        const auto weights = graph.neighbour_weights(i);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (columns[k] >= i) edges.push_back({new_id[i], new_id[columns[k]], weights[k]});
        }
    }
    return build_graph(edges, std::move(area_m2));
}

inline std::vector<std::uint32_t> random_permutation(Random& random, std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

/// Graphs put side by side, their nodes one after the other, without an edge between them.
inline Graph disjoint_union(const std::vector<Graph>& graphs) {
    std::vector<WeightedEdge> edges;
    std::vector<double> area_m2;
    for (const Graph& graph : graphs) {
        const std::size_t begin = area_m2.size();
        for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
            const auto columns = graph.neighbours(i);
            const auto weights = graph.neighbour_weights(i);
            for (std::size_t k = 0; k < columns.size(); ++k) {
                if (columns[k] < i) continue;
                edges.push_back({node_id(begin + i), node_id(begin + columns[k]), weights[k]});
            }
        }
        area_m2.insert(area_m2.end(), graph.area_m2.begin(), graph.area_m2.end());
    }
    return build_graph(edges, std::move(area_m2));
}

/// Largest |v_i . v_j - delta_ij|.
inline double orthonormality_error(const Eigenpairs& pairs) {
    double error = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const auto a = pairs.vector(i);
            const auto b = pairs.vector(j);
            const double dot = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
            error = std::max(error, std::abs(dot - (i == j ? 1.0 : 0.0)));
        }
    }
    return error;
}

/// Largest |L v - lambda v|, with the Laplacian of the whole graph.
inline double largest_residual(const Eigenpairs& pairs, const Laplacian& laplacian) {
    double largest = 0.0;
    std::vector<double> product(pairs.num_nodes);
    for (std::size_t j = 0; j < pairs.size(); ++j) {
        const auto vector = pairs.vector(j);
        laplacian.apply(vector, product);
        double squared = 0.0;
        for (std::size_t i = 0; i < pairs.num_nodes; ++i) {
            squared += std::pow(product[i] - pairs.values[j] * vector[i], 2);
        }
        largest = std::max(largest, std::sqrt(squared));
    }
    return largest;
}

}  // namespace quadcut::test
