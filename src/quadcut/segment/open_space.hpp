// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/raster.hpp"

namespace quadcut {

struct OpenSpaceOptions {
    /// Obstacles that touch nothing else and cover less, holes included, are furniture, m^2; but
    /// not the pieces of a wall between its doors.
    double max_furniture_m2 = 0.3;
};

/// The space in which widths are measured, 1 = open: the free cells of `kept`, and the furniture
/// that stands in them. Small isolated obstacles (legs of tables and chairs, bins) do not make a
/// room narrower; what is enclosed by one belongs to it.
/// `kept`: 1 = a free cell that is part of the result. O(cells).
[[nodiscard]] Raster<std::uint8_t> open_space(const Raster<std::uint8_t>& kept, double resolution_m,
                                              const OpenSpaceOptions& options = {});

}  // namespace quadcut
