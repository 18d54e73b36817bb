// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// Calls `append(node, edges)` for each node from 0 on, sorts the edges it appended by their second
/// end, and joins the rows in order: the same bytes on any number of threads. `append` is called
/// from several threads and may only read what they share.
[[nodiscard]] std::vector<WeightedEdge> collect_edge_rows(
    std::size_t num_nodes, const Executor& executor,
    const std::function<void(std::uint32_t node, std::vector<WeightedEdge>& edges)>& append);

}  // namespace quadcut
