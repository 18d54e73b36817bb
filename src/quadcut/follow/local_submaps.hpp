// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <map>
#include <set>

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/local_cut.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// Leaves of up to this side, in cells, are the same in a window as in the whole map.
inline constexpr std::int32_t kWindowBlock = 128;

/// What the paper's incremental segmentation looks at; rasters of one rectangle, whose lower left
/// is that of a block of kWindowBlock cells of the map's quadtree.
struct SubmapWindow {
    Raster<CellState> states;
    /// The submap of each cell; 0 = none.
    Raster<std::uint32_t> submaps;
    /// 1 = updated since the last cut.
    Raster<std::uint8_t> updated;
    /// The old submaps that were seen since then in one observation with something new; they lie
    /// wholly in the window.
    std::set<std::uint32_t> seen;
    /// Of submaps that people made one, as in LocalWindow.
    std::map<std::uint32_t, std::uint32_t> merge_groups;
    double resolution_m = 0.05;
};

/// The paper's steps 2 to 7 (READING.md, items 22 and 23): updated leaves make new submaps; the old
/// ones that were seen with them and are relevant to them, by an edge of G, join them in the
/// temporary list; the auxiliary graph of all their leaves is clustered, divided and fused by the
/// same steps as a whole map. All else is kNotCut. num_nodes is the size of the auxiliary graph's
/// matrix. Step 2's own clustering is left out: all its submaps go to the list, whatever they are.
/// O(leaves of the window), and an eigenproblem of the auxiliary graph.
[[nodiscard]] LocalCut cut_submaps(const SubmapWindow& window, const SegmentOptions& options,
                                   const Executor& executor);

}  // namespace quadcut
