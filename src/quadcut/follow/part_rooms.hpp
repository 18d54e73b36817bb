// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/follow/followed_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The room that most cells of each part 1 .. count had; 0 where most had none. O(cells).
[[nodiscard]] std::vector<std::uint32_t> majority_rooms(const Raster<std::uint32_t>& parts,
                                                        std::uint32_t count,
                                                        const Raster<std::uint32_t>& rooms);

/// The merge group of each of these rooms; 0 = none.
[[nodiscard]] std::vector<std::uint32_t> groups_of(const std::vector<std::uint32_t>& rooms,
                                                   const FollowedMap& followed);

/// Calls visit(i, j) for each two cells (offsets) side by side.
template <typename Visit>
void for_each_pair(const Raster<std::uint32_t>& raster, const Visit& visit) {
    const auto width = static_cast<std::size_t>(raster.width);
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        if ((i + 1) % width != 0) visit(i, i + 1);
        if (i + width < raster.values.size()) visit(i, i + width);
    }
}

}  // namespace quadcut
