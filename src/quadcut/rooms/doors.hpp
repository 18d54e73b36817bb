// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/room.hpp"
#include "quadcut/rooms/region_graph.hpp"

namespace quadcut {

/// Narrower openings are gaps in the map.
inline constexpr double kMinDoorM = 0.3;

/// The openings between regions, each of them: two rooms may share several doors. `labels` 1 ..
/// num_regions; `clearance_m` as the regions were made with; positions come out in the map frame.
/// Openings narrower than `min_width_m` are left out. Ordered by a, b, then first cell.
/// O(cells + 5 m around each opening).
[[nodiscard]] std::vector<Door> find_doors(const Raster<std::uint32_t>& labels,
                                           std::uint32_t num_regions, const Ground& ground,
                                           const LaidOutFrame& frame, double min_width_m,
                                           const Executor& executor = {});

/// A door, and the two cells beside each other, one in each of its rooms, where it is widest.
struct PlacedDoor {
    Door door;
    Cell a;
    Cell b;
    friend bool operator==(const PlacedDoor&, const PlacedDoor&) = default;
};

/// The same for a part of a map: the doors whose cell a lies in `box`, where `beyond` is what each
/// region 1 .. num_regions has outside of the part; nothing: all is inside. O(cells + 5 m around
/// each of these).
[[nodiscard]] std::vector<PlacedDoor> find_doors_in(const Box& box, std::span<const Beyond> beyond,
                                                    const Raster<std::uint32_t>& labels,
                                                    std::uint32_t num_regions, const Ground& ground,
                                                    const LaidOutFrame& frame, double min_width_m,
                                                    const Executor& executor = {});

}  // namespace quadcut
