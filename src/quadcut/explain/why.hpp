// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/explain/decisions.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/rooms/door_model.hpp"

namespace quadcut {

struct SegmentOptions;

/// What is at a place.
enum class PlaceKind : std::uint8_t { beyond_map, occupied, unknown, left_out, room };

/// The border that a place is near to, and what was decided about it. Positions: map frame, metres.
struct NearBorder {
    Decision decision;
    /// How far the place is from the border, or from the widest place of one that is no more.
    double distance_m = 0.0;
    /// The middles of two cells beside each other where the opening is widest, one on each side.
    std::array<Point, 2> sides;
    /// From which granularity on it is cut; it may be beyond 0 .. 1.
    double granularity = 0.0;
    /// What each cue added to the log-odds.
    std::array<double, kNumDoorCues> contributions{};
};

/// Why the map is cut at a place, or is not.
struct Why {
    PlaceKind ground = PlaceKind::beyond_map;
    /// To the nearest obstacle that counts; of a place in a room.
    double clearance_m = 0.0;
    std::optional<NearBorder> border;
};

/// Cuts the map again by the preset `rooms`, and says what was decided near a place (metres, map
/// frame): the nearest border between two rooms if it is within 1 m; or else, within 2 m, the most
/// door-like of the borders that were fused; or else nothing proposed a cut there. `trajectory` as
/// in segment(). Cost as segment(), and each join is measured.
[[nodiscard]] Why why(const GridMap& map, const SegmentOptions& options, const Point& place,
                      const RunOptions& run = {}, std::span<const Point> trajectory = {});

}  // namespace quadcut
