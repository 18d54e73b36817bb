// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::draw {

// What a cell of a floor plan is drawn as. Values 1 to 65532 are rooms (should there be more, all
// further ones are drawn as the last of these); 0 is paper.
inline constexpr std::uint16_t kFirstNonRoom = 65533;
/// Free, but of no room.
inline constexpr std::uint16_t kLooseFree = kFirstNonRoom;
/// Thin and unknown, probably a wall that was not seen.
inline constexpr std::uint16_t kWallCore = kFirstNonRoom + 1;
/// Occupied, or thin and between occupied cells.
inline constexpr std::uint16_t kWall = kFirstNonRoom + 2;

[[nodiscard]] constexpr bool is_room(std::uint16_t ground) {
    return ground > 0 && ground < kFirstNonRoom;
}

// What stands on the floor.
inline constexpr std::uint8_t kFurniture = 1;
/// What the map could not see into, or the inside of a desk drawn as an outline.
inline constexpr std::uint8_t kFurnitureInside = 2;

/// A map and its rooms, sorted for drawing. Both rasters cover the same part of the map.
struct FloorCells {
    /// One of the values above for each cell; a room reaches under its furniture.
    Raster<std::uint16_t> ground;
    /// kFurniture, kFurnitureInside or 0.
    Raster<std::uint8_t> furniture;
};

/// Sorts the cells of the part of the map that has rooms, and a margin around it (all that is known
/// if there are no rooms). Furniture: what is not free within a room's labels, unlabelled cells
/// that one room encloses on all sides, and free ones that no room can reach, up to 4 m long.
/// Walls: up to 0.5 m thick; what is occupied within 0.15 m of a room's border, labelled or not; of
/// occupied blocks of a metre and more the outer 0.25 m. O(cells), with two bytes a cell beside the
/// result.
/// @pre labels and map.states cover the same rectangle, which is not empty.
[[nodiscard]] FloorCells sort_floor_cells(const GridMap& map, const Raster<std::uint16_t>& labels,
                                          const Executor& executor = {});

}  // namespace quadcut::draw
