// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// For every cell that is not `blocked` (value 0): the distance from its centre to the border of
/// the nearest blocked cell's inscribed disc, metres: exact Euclidean centre distance less half a
/// cell. 0 in blocked cells. The outside of the raster is blocked.
///
/// Meijster, Roerdink and Hesselink, "A general algorithm for computing distance transforms in
/// linear time", 2000. O(cells), one float and a few rows of memory: that of `memory`, a raster
/// that is not needed any more, where it is large enough. The same bytes on any number of threads.
[[nodiscard]] Raster<float> clearance_m(const Raster<std::uint8_t>& open, double resolution_m,
                                        const Executor& executor = {}, Raster<float> memory = {});

}  // namespace quadcut
