// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/follow/window.hpp"
#include "quadcut/rooms/region_graph.hpp"

// What rooms have beyond the window that is being cut: looked at tile by tile, since a room may go
// on for kilometres, and the box around it may hold next to nothing of it.

namespace quadcut {

/// Which parts of one room, a cell of each, are connected outside of the window; `labels` has the
/// part of each cell of the window. O(tiles of the room) when there are several parts.
[[nodiscard]] Outside look_outside(const FollowedMap& followed, const Window& window,
                                   std::uint32_t room, const std::vector<Cell>& parts,
                                   const Raster<std::uint32_t>& labels);

/// What each group has out there, as the graph of regions sees it.
[[nodiscard]] std::vector<Beyond> beyond_of(const FollowedMap& followed, const Box& window,
                                            std::uint32_t room, const Outside& outside);

/// The cells of a group out there.
[[nodiscard]] std::vector<Cell> cells_outside(const FollowedMap& followed, const Window& window,
                                              std::uint32_t room, const Outside& outside,
                                              std::size_t group);

}  // namespace quadcut
