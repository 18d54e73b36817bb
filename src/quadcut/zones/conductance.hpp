// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/segment/result.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// G_submap of the paper: rooms as nodes, by their places in Segmentation::rooms, with their areas.
/// A door's weight is its conductance (docs/decisions/0020); doors between the same two rooms add
/// up. O(rooms + doors).
[[nodiscard]] Graph conductance_graph(const Segmentation& segmentation);

}  // namespace quadcut
