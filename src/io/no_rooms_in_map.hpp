// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut::io {

/// Why a map has no rooms, and which option would have it otherwise: no free cell, all free space
/// too small or too narrow, or ground outside. @pre segment() found none with the same arguments.
/// O(cells).
[[nodiscard]] std::string why_no_rooms(const GridMap& map, const SegmentOptions& options,
                                       std::span<const Point> trajectory = {});

}  // namespace quadcut::io
