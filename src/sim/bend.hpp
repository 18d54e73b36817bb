// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "sim/building.hpp"

namespace quadcut::sim {

/// The building with its straight lines along x bent to arcs about a centre far below it (above it,
/// for a negative radius): `radius_m` is that of the line through its middle, which keeps its
/// length. What lies farther out becomes longer, what lies nearer shorter, by a quarter at most.
///
/// Maps are resampled, nearest cell; floors are no longer convex, their edges are cut every metre.
/// Throws std::logic_error when the radius is less than twice the building's height. O(cells).
[[nodiscard]] Building bent(const Building& building, double radius_m);

}  // namespace quadcut::sim
