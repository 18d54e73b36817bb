// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/window.hpp"
#include "quadcut/segment/options.hpp"

// The paper's incremental segmentation.

namespace quadcut {

/// Adds the submaps in an observation that brought something new to those that were seen. Nothing
/// but in the preset `paper`.
void note_seen(FollowedMap& followed, Preset preset, const std::vector<Cell>& tiles);

/// What it looks at: all that has changed, and the submaps that were seen. Its lower left is that
/// of a block of the map's quadtree.
[[nodiscard]] Window window_of_seen(const FollowedMap& followed);

/// Steps 2 to 7 of the paper's "Local corresponding matrix generation": updated leaves make new
/// submaps; the old ones that were seen with them and are relevant to them, by an edge of G, join
/// them in the temporary list; the auxiliary graph of all their leaves is clustered, divided and
/// fused by the same steps as a whole map. All else is kNotCut. num_nodes is the size of the
/// auxiliary graph's matrix. Step 2's own clustering is left out: all its submaps go to the list,
/// whatever they are. O(leaves of the window), and an eigenproblem of the auxiliary graph.
[[nodiscard]] WindowCut cut_submaps(const FollowedMap& followed, const Window& window,
                                    const SegmentOptions& options, const Executor& executor);

}  // namespace quadcut
