// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>

#include "quadcut/spectral/graph.hpp"

namespace quadcut::reproduce {

/// Bytes of a graph's weights in each storage: what would be allocated, without allocating it; the
/// largest number there is when they are more. As a dense matrix:
[[nodiscard]] std::size_t dense_bytes(const Graph& graph);
/// In compressed sparse rows, as they are kept:
[[nodiscard]] std::size_t csr_bytes(const Graph& graph);
/// By diagonals, the storage that the paper proposes: each that holds an entry, with its offset. It
/// pays only when the entries lie on few diagonals; a quadtree's do not. O(nodes + entries).
[[nodiscard]] std::size_t dia_bytes(const Graph& graph);

}  // namespace quadcut::reproduce
