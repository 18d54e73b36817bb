// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <vector>

#include "quadcut/base/ids.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// The pairs of leaves of a region that share a border of positive length, with the weight shared
/// length / distance between the centres, a pure number: the finite-volume discretisation of the
/// free space, which hardly depends on how the quadtree happened to split. A corner is no border.
///
/// `nodes` are free leaves of the table, ascending; edge ends are positions in `nodes`. The left or
/// lower leaf comes first; pairs ascend; each is there once. The same bytes on any number of
/// threads. Time O(edges + cells along borders with nothing beyond), memory O(edges).
/// Throws std::logic_error if `nodes` is not as said.
[[nodiscard]] std::vector<WeightedEdge> border_edges(const LeafTable& table,
                                                     std::span<const LeafId> nodes,
                                                     const Executor& executor = {});

}  // namespace quadcut
