// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/rooms/options.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/rooms/rooms.hpp"

namespace quadcut {

/// What became of a border between two regions.
enum class Verdict : std::uint8_t {
    cut,
    /// Fused: it is less like a door than the granularity asks for.
    no_door,
    /// Fused: wider than any door.
    too_wide,
    /// Fused: one side is smaller than a room, or nowhere as wide as a robot.
    too_small,
    /// Fused before anything was measured: the spectral cut made both one piece.
    one_piece,
};

/// A border between two regions when it was decided about, at the saddle.
struct Decision {
    Saddle saddle;
    BorderMeasure border;
    double log_odds = 0.0;
    Verdict verdict = Verdict::cut;
};

/// A cut, and how it came about.
struct DecidedCut {
    RoomsCut cut;
    /// Of the rooms that are left, then those of all joins in their order.
    std::vector<Decision> decisions;
};

/// cut_into_rooms() of a whole map, with all decisions. Rasters and cost as there; each join is
/// measured.
[[nodiscard]] DecidedCut cut_with_decisions(FloorToCut floor, const RoomsOptions& options,
                                            const Executor& executor);

}  // namespace quadcut
