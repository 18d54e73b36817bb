// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

namespace quadcut {

struct OptionField;

/// What is fused into rooms: the basins of the clearance, or unions of them that the spectral cut
/// of their graph makes.
enum class PieceSource : std::uint8_t { basins, spectral };

/// The preset `rooms`. Two knobs are public; the rest is for experiments.
struct RoomsOptions {
    double granularity = 0.5;
    double door_width_m = 4.0;
    double min_component_m2 = 2.0;
    double max_furniture_m2 = 0.3;
    PieceSource pieces = PieceSource::spectral;
    double min_room_m2 = 1.5;
    double min_passable_m = 0.4;
};

/// Adds the options of this stage, bound to the members of `options`, which must outlive the list.
void add_fields(RoomsOptions& options, std::vector<OptionField>& fields);

}  // namespace quadcut
