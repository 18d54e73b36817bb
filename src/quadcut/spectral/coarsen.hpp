// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// A graph of fewer nodes, each made of some nodes of a finer one.
struct Coarsening {
    std::vector<std::uint32_t> coarse_of_node;
    /// Without self-loops; its area_m2 are the sums of the finer nodes' volumes.
    Graph graph;
};

/// Puts nodes together along heavy edges: each, in order, joins the neighbour that it is bound to
/// most strongly for the two volumes, w (1 / v_a + 1 / v_b) (Dhillon, Guan, Kulis 2007), alone or
/// with what that one has joined already, up to four nodes and `max_volume`. Halves to thirds the
/// number of nodes where volumes allow. `volumes`: one a node, positive. O(nodes + edges).
[[nodiscard]] Coarsening coarsen(const Graph& graph, std::span<const double> volumes,
                                 double max_volume);

}  // namespace quadcut
