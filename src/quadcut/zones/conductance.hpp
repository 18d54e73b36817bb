// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>

#include "quadcut/segment/result.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// G_submap of the paper: rooms as nodes, by their places in Segmentation::rooms, with their areas.
/// A door conducts as well as it is wide, up to 1 m (docs/decisions/0020); doors between the same
/// two rooms add up. O(doors + rooms).
[[nodiscard]] Graph conductance_graph(const Segmentation& segmentation);

/// The same made connected: what no doors join, closed rooms and buildings apart, is joined weakly
/// by nearness. A cut takes a large part away there first, a single room never. O(rooms) times the
/// rooms outside of the largest component.
[[nodiscard]] Graph joined_by_nearness(Graph graph, std::span<const Room> rooms);

}  // namespace quadcut
