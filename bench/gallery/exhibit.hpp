// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bench/gallery/comparison.hpp"
#include "io/label_image.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::gallery {

/// A map with rooms that are numbered like the regions of a comparison; of a room, only its id and
/// kind are filled in.
struct Side {
    GridMap map;
    Segmentation rooms;
};

/// Truth and result on the same cells.
struct Exhibit {
    std::string name;
    Side truth;
    Side result;
    Comparison comparison;
    /// 1 where the result has a room that counts nowhere: a speck, or one in the void.
    Raster<std::uint8_t> left_out;
};

/// With the cells that are surely free, rooms in the void are left out (eval::without_void).
/// @pre all have the same cells. Throws InputError when they differ in size.
[[nodiscard]] Exhibit make_exhibit(std::string name, const GridMap& truth_map,
                                   const io::LabelImage& truth, const GridMap& result_map,
                                   const Segmentation& result,
                                   const std::optional<io::FreeMask>& surely_free = std::nullopt);

/// What a map and its rooms have at the centres of the cells of `frame`; unknown and 0 beyond.
/// Doors and rooms stay as they are. O(cells of the frame).
[[nodiscard]] Side resampled(const GridMap& frame, const GridMap& map, const Segmentation& rooms);

}  // namespace quadcut::gallery
