// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

struct SegmentOptions;

/// Cuts a finished map into rooms, by the preset in `options`.
///
/// `trajectory`: where the robot has been, metres in the map frame; may be empty. It tells inside
/// from outside. `earlier`: the rooms of an earlier result on the map's cells (0 = none), which are
/// evidence in the preset `rooms`: the same map has the same rooms again, and where it has grown a
/// cut changes only when what is measured there clearly says so; may be empty. A map without free
/// space gives no rooms. Deterministic: the same rooms for the same input, however it runs. Throws
/// NumericalError if an eigensolver fails its checks, InputError if there are more than 65,535
/// rooms.
[[nodiscard]] Segmentation segment(const GridMap& map, const SegmentOptions& options,
                                   const RunOptions& run = {},
                                   std::span<const Point> trajectory = {},
                                   const Raster<std::uint16_t>& earlier = {});
/// With the options as they are (quadcut/segment/options.hpp).
[[nodiscard]] Segmentation segment(const GridMap& map);

}  // namespace quadcut
