// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

#include "io/map_yaml.hpp"
#include "io/palette.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// The keys of a map_server YAML for an image of the map's cells. Resolution and origin are the
/// map's own, the rest is as given; numbers read back exactly.
[[nodiscard]] std::string to_map_yaml(const GridMap& map, const MapKeys& keys);

/// The keys of the map for the label image `keys.image`, and `labels`: what each value of it means.
/// A room's value is its id; `next_id` is higher than any id that was ever given. Positions in
/// metres, map frame. colors[i] is the colour of rooms[i].
[[nodiscard]] std::string to_rooms_yaml(const GridMap& map, const MapKeys& keys,
                                        const Segmentation& segmentation,
                                        std::span<const Rgb> colors);

}  // namespace quadcut::io
