// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "quadcut/base/random.hpp"
#include "sim/shape.hpp"

namespace quadcut::sim {

/// How one wing is built.
struct WingStyle {
    double corridor_m = 2.0;
    /// Depth of the rooms on the outer and on the inner side of a corridor.
    double outer_depth_m = 5.0;
    double inner_depth_m = 5.0;
    double corridor_wall_m = 0.15;
    double partition_m = 0.12;
    double outer_wall_m = 0.22;
};

/// A row of rooms along a corridor, in the wing's frame. In `frame` it is
/// [0, length] x [0, depth], with the corridor's wall below y = 0.
struct Strip {
    Frame frame;
    double length = 0.0;
    double depth = 0.0;
    /// Where along the strip the corridor runs: doors must lie in between.
    double front_begin = 0.0;
    double front_end = 0.0;
    std::size_t corridor = 0;
};

/// The open end of a corridor: `frame` has its origin in the middle of the end line and v
/// outwards.
struct Port {
    Frame frame;
    std::size_t corridor = 0;
};

/// The corridors of a wing and the rows of rooms along them, in the wing's own frame.
struct Skeleton {
    struct CorridorPart {
        Rect rect;
        std::size_t corridor = 0;
    };
    /// A fire door between two corridors: room a on the lower y side of the opening in `frame`.
    struct FireDoor {
        Frame frame;
        Rect opening;
        std::size_t a = 0;
        std::size_t b = 0;
    };
    std::size_t num_corridors = 1;
    std::vector<CorridorPart> corridors;
    std::vector<Strip> strips;
    std::vector<FireDoor> fire_doors;
    std::vector<Port> ports;
    /// Courtyards.
    std::vector<Rect> voids;
    /// Everything built, walls included.
    std::vector<Rect> footprint;
};

/// A wing with about `frontage_m` metres of rooms along its corridors: straight, L, U, ring or
/// comb, as the length allows.
[[nodiscard]] Skeleton draw_skeleton(const WingStyle& style, double frontage_m, Random& random);

}  // namespace quadcut::sim
