// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/graph/graph.hpp"

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

/// The offsets of the diagonals that hold an entry, ascending. O(nodes + entries).
[[nodiscard]] std::vector<std::int64_t> diagonal_offsets(const Graph& graph);

/// Bytes of the weights in each storage: what would be allocated, without allocating it.
[[nodiscard]] std::size_t dense_bytes(const Graph& graph);
[[nodiscard]] std::size_t csr_bytes(const Graph& graph);
[[nodiscard]] std::size_t dia_bytes(const Graph& graph);

/// The weights by diagonals. Throws std::length_error if that takes more than `max_bytes`: ask
/// dia_bytes() before. O(dia_bytes).
[[nodiscard]] DiaMatrix build_dia(const Graph& graph, std::size_t max_bytes);

/// W x, each row summed by ascending column. @pre x.size() == number of rows, else
/// std::logic_error.
[[nodiscard]] std::vector<double> multiply(const DiaMatrix& matrix, std::span<const double> x);
[[nodiscard]] std::vector<double> multiply(const Graph& graph, std::span<const double> x);

}  // namespace quadcut
