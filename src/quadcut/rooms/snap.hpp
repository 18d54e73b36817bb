// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>

#include "quadcut/base/ids.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/rooms/basins.hpp"

namespace quadcut {

/// Moves the borders of spectral pieces to the narrowest lines of the free space: each basin goes
/// whole to the piece that holds most of it, and basins of one piece that touch become one. Thus a
/// cut that runs near a doorway lies in it.
///
/// `piece_of_node`: the piece of each leaf in `nodes`. Cells are those of the basins' raster; what
/// is in no leaf of `nodes` counts for none. Labels of the result: 1 .. count, by first cell.
/// O(cells).
[[nodiscard]] Basins snap_to_basins(const Basins& basins, const LeafTable& leaves,
                                    std::span<const LeafId> nodes,
                                    std::span<const std::uint32_t> piece_of_node);

}  // namespace quadcut
