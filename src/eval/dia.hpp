// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// A square matrix by its diagonals, the storage that the paper proposes for the graph's weights:
/// diagonal d holds the entries (i, i + offsets[d]), and values[d * size + i] is the one of row i.
/// Offsets ascend. Places beyond the matrix hold 0. It pays only when the entries lie on few
/// diagonals; a quadtree's do not, so the graph itself stays in compressed sparse rows.
struct DiaMatrix {
    std::size_t size = 0;
    std::vector<std::int64_t> offsets;
    std::vector<double> values;
};

/// a * b, or the largest number there is.
[[nodiscard]] inline std::size_t bounded_product(std::size_t a, std::size_t b) {
    constexpr std::size_t kMax = std::numeric_limits<std::size_t>::max();
    return b != 0 && a > kMax / b ? kMax : a * b;
}

[[nodiscard]] inline std::size_t dia_bytes(std::size_t size, std::size_t num_diagonals) {
    return bounded_product(num_diagonals, sizeof(std::int64_t) + size * sizeof(double));
}

/// The offsets of the diagonals that hold an entry, ascending. O(nodes + entries).
[[nodiscard]] inline std::vector<std::int64_t> diagonal_offsets(const Graph& graph) {
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

/// Bytes of the weights in each storage: what would be allocated, without allocating it.
[[nodiscard]] inline std::size_t dense_bytes(const Graph& graph) {
    return bounded_product(graph.num_nodes(), bounded_product(graph.num_nodes(), sizeof(double)));
}

[[nodiscard]] inline std::size_t csr_bytes(const Graph& graph) {
    return graph.row_begin.size() * sizeof(graph.row_begin[0]) +
           graph.columns.size() * (sizeof(graph.columns[0]) + sizeof(graph.weights[0]));
}

[[nodiscard]] inline std::size_t dia_bytes(const Graph& graph) {
    return dia_bytes(graph.num_nodes(), diagonal_offsets(graph).size());
}

/// The weights by diagonals. Throws std::length_error if that takes more than `max_bytes`: ask
/// dia_bytes() before. O(dia_bytes).
[[nodiscard]] inline DiaMatrix build_dia(const Graph& graph, std::size_t max_bytes) {
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

/// W x, each row summed by ascending column. @pre x.size() == number of rows, else
/// std::logic_error.
[[nodiscard]] inline std::vector<double> multiply(const DiaMatrix& matrix,
                                                  std::span<const double> x) {
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

[[nodiscard]] inline std::vector<double> multiply(const Graph& graph, std::span<const double> x) {
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
