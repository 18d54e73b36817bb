// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "io/pixel_states.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

/// Whether walls are drawn on a transparent ground: what is opaque is hardly ever free, whereas
/// programs that leave the unknown transparent draw the floor.
[[nodiscard]] bool is_drawn_on_transparent(const GreyTally& tally, const MapKeys& keys);

/// A map of which what lies outside of the walls is unknown.
struct WalledFloor {
    GridMap map;
    /// Whether the walls enclose a place where a disc of 1.5 m fits. If not, the map is as it was.
    bool is_enclosed = false;
};

/// Free space that is connected with the edge of the image is outside. What is behind openings of
/// up to 1.5 m is not, if it is wider than that. O(cells), about 9 bytes a cell.
[[nodiscard]] WalledFloor take_outside_away(GridMap map);

}  // namespace quadcut::io
