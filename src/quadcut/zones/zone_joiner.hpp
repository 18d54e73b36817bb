// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>

#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// Clusters samples, one a node of the graph, by Ward's method along its edges: joins the two
/// clusters that have an edge between them and whose joining adds least to the sum of squared
/// distances to the means, each sample weighted by its degree, until `count` are left or no edge
/// is. With the rows divided by sqrt(d) that sum is the normalised cut's relaxation (Dhillon, Guan,
/// Kulis 2004). Each cluster is connected. O(edges log edges, times dims and joins' neighbours).
[[nodiscard]] Clustering join_into_zones(const Graph& graph, const Embedding& samples,
                                         std::size_t count);

}  // namespace quadcut
