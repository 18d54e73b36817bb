// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// One sweep of a planar laser range finder. Beam i points to
/// `first_angle_rad + i * angle_step_rad` in the sensor frame (x forward, counter-clockwise) and
/// returned `ranges_m[i]`. A range that is not finite or <= 0 is an invalid beam: it says nothing.
/// A range >= max_range_m is "no return": nothing was hit, and nothing is concluded from it.
struct Scan {
    Pose world_from_sensor;
    double first_angle_rad = 0.0;
    double angle_step_rad = 0.0;
    double max_range_m = 0.0;
    double time_s = 0.0;
    std::vector<float> ranges_m;
};

}  // namespace quadcut
