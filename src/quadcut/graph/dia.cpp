// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/graph/dia.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace quadcut {
namespace {

/// a * b, or the largest number there is.
std::size_t bounded_product(std::size_t a, std::size_t b) {
    constexpr std::size_t kMax = std::numeric_limits<std::size_t>::max();
    return b != 0 && a > kMax / b ? kMax : a * b;
}

std::size_t dia_bytes(std::size_t size, std::size_t num_diagonals) {
    return bounded_product(num_diagonals, sizeof(std::int64_t) + size * sizeof(double));
}

}  // namespace

std::vector<std::int64_t> diagonal_offsets(const Graph& graph) {
    const auto size = static_cast<std::int64_t>(graph.num_nodes());
    std::vector<bool> present(static_cast<std::size_t>(2 * size), false);
    for (std::int64_t row = 0; row < size; ++row) {
        for (const std::uint32_t column : graph.neighbours(static_cast<std::size_t>(row))) {
            present[static_cast<std::size_t>(column + size - row)] = true;
        }
    }
    std::vector<std::int64_t> offsets;
    for (std::size_t i = 0; i < present.size(); ++i) {
        if (present[i]) offsets.push_back(static_cast<std::int64_t>(i) - size);
    }
    return offsets;
}

std::size_t dense_bytes(const Graph& graph) {
    return bounded_product(graph.num_nodes(), bounded_product(graph.num_nodes(), sizeof(double)));
}

std::size_t csr_bytes(const Graph& graph) {
    return graph.row_begin.size() * sizeof(graph.row_begin[0]) +
           graph.columns.size() * (sizeof(graph.columns[0]) + sizeof(graph.weights[0]));
}

std::size_t dia_bytes(const Graph& graph) {
    return dia_bytes(graph.num_nodes(), diagonal_offsets(graph).size());
}

DiaMatrix build_dia(const Graph& graph, std::size_t max_bytes) {
    DiaMatrix matrix;
    matrix.size = graph.num_nodes();
    matrix.offsets = diagonal_offsets(graph);
    if (dia_bytes(matrix.size, matrix.offsets.size()) > max_bytes) {
        throw std::length_error("build_dia: the diagonals take more than the bytes allowed");
    }
    matrix.values.assign(matrix.offsets.size() * matrix.size, 0.0);
    for (std::size_t row = 0; row < matrix.size; ++row) {
        // Columns and offsets both ascend: one pass over the offsets finds the diagonal of each.
        auto offset = matrix.offsets.begin();
        for (std::size_t k = graph.row_begin[row]; k < graph.row_begin[row + 1]; ++k) {
            const std::int64_t wanted =
                std::int64_t{graph.columns[k]} - static_cast<std::int64_t>(row);
            offset = std::lower_bound(offset, matrix.offsets.end(), wanted);
            const auto diagonal = static_cast<std::size_t>(offset - matrix.offsets.begin());
            matrix.values[diagonal * matrix.size + row] = graph.weights[k];
        }
    }
    return matrix;
}

std::vector<double> multiply(const DiaMatrix& matrix, std::span<const double> x) {
    if (x.size() != matrix.size) throw std::logic_error("multiply: the sizes do not match");
    std::vector<double> y(matrix.size, 0.0);
    const auto size = static_cast<std::int64_t>(matrix.size);
    for (std::size_t d = 0; d < matrix.offsets.size(); ++d) {
        const std::int64_t offset = matrix.offsets[d];
        const double* values = &matrix.values[d * matrix.size];
        const std::int64_t last = std::min(size, size - offset);
        for (std::int64_t row = std::max<std::int64_t>(0, -offset); row < last; ++row) {
            y[static_cast<std::size_t>(row)] +=
                values[row] * x[static_cast<std::size_t>(row + offset)];
        }
    }
    return y;
}

std::vector<double> multiply(const Graph& graph, std::span<const double> x) {
    if (x.size() != graph.num_nodes()) throw std::logic_error("multiply: the sizes do not match");
    std::vector<double> y(x.size(), 0.0);
    for (std::size_t row = 0; row < y.size(); ++row) {
        double sum = 0.0;
        for (std::size_t k = graph.row_begin[row]; k < graph.row_begin[row + 1]; ++k) {
            sum += graph.weights[k] * x[graph.columns[k]];
        }
        y[row] = sum;
    }
    return y;
}

}  // namespace quadcut
