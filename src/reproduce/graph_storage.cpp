// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/graph_storage.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadcut::reproduce {
namespace {

std::size_t bounded_product(std::size_t a, std::size_t b) {
    constexpr std::size_t kMax = std::numeric_limits<std::size_t>::max();
    return b != 0 && a > kMax / b ? kMax : a * b;
}

std::size_t num_diagonals(const Graph& graph) {
    const std::size_t size = graph.num_nodes();
    std::vector<bool> present(2 * size, false);
    for (std::size_t row = 0; row < size; ++row) {
        for (const std::uint32_t column : graph.neighbours(row)) {
            present[column + size - row] = true;
        }
    }
    return static_cast<std::size_t>(std::count(present.begin(), present.end(), true));
}

}  // namespace

std::size_t dense_bytes(const Graph& graph) {
    return bounded_product(graph.num_nodes(), bounded_product(graph.num_nodes(), sizeof(double)));
}

std::size_t csr_bytes(const Graph& graph) {
    return graph.row_begin.size() * sizeof(graph.row_begin[0]) +
           graph.columns.size() * (sizeof(graph.columns[0]) + sizeof(graph.weights[0]));
}

std::size_t dia_bytes(const Graph& graph) {
    return bounded_product(num_diagonals(graph),
                           sizeof(std::int64_t) + graph.num_nodes() * sizeof(double));
}

}  // namespace quadcut::reproduce
