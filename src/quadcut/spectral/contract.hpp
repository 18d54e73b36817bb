// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// The basin of each node, numbered from 0 by first node: what leads to the same summit, when each
/// node leads to its neighbour of the largest degree (the sum of its weights, loops included), if
/// that is larger than its own; of equals to the first. Connected. O(nodes + edges).
[[nodiscard]] std::vector<std::uint32_t> degree_basins(const Graph& graph);

/// The graph whose nodes are the groups 0 .. of `group_of_node`, with the sums of areas and of the
/// weights between them; what lies inside a group is a loop, with each edge counted in both
/// directions, so that degrees add up. So its normalised cuts are those of the graph that part no
/// group, and no eigenvalue of its Laplacian is below the graph's of the same place. O(nodes +
/// edges).
[[nodiscard]] Graph contract(const Graph& graph, std::span<const std::uint32_t> group_of_node);

}  // namespace quadcut
