// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"
#include "quadcut/zones/sightings.hpp"

namespace quadcut {

/// A scan within this distance of a door, the line from jamb to jamb, stands at it.
inline constexpr double kAtDoorM = 2.0;
/// Two parts are independent when fewer of the scans than this see both.
inline constexpr double kIndependentShare = 0.1;

/// Of some scans: those that see one of two parts or both, and those that see both.
struct SharedScans {
    std::size_t either = 0;
    std::size_t both = 0;
    /// 0 when no scan sees either.
    [[nodiscard]] double share() const {
        return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
    }
    friend bool operator==(const SharedScans&, const SharedScans&) = default;
};

/// Two parts of a map: zones by number, or rooms by id. a < b.
struct PairIndependence {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    /// Doors from one to the other.
    std::size_t num_doors = 0;
    SharedScans all;
    /// Given the doors: of the scans that do not stand at a door from one to the other. What those
    /// at it see belongs to both, as in SLAM the poses that separate two submaps.
    SharedScans given_doors;
    friend bool operator==(const PairIndependence&, const PairIndependence&) = default;
};

/// How independent the parts of a map are of each other: what the paper leaves to future work
/// (Conclusion).
struct Independence {
    std::size_t num_parts = 0;
    /// Scans that stood in a part.
    std::size_t num_scans = 0;
    /// Of the floor that these saw, all scans together, what lies in another part: 0 .. 1.
    double seen_outside = 0.0;
    /// Those with a scan that sees both, or a door, in order. All other pairs share nothing.
    std::vector<PairIndependence> pairs;

    /// Of all, whether a scan sees both or not.
    [[nodiscard]] std::size_t num_pairs() const { return num_parts * (num_parts - 1) / 2; }
};

/// Of the zones of a map, by number, and of its rooms, by id.
struct IndependenceReport {
    Independence zones;
    Independence rooms;
};

/// Of pairs, how many are independent. `of` is &PairIndependence::all or ::given_doors.
[[nodiscard]] std::size_t num_independent(std::span<const PairIndependence> pairs,
                                          SharedScans PairIndependence::*of);

/// Of rooms, by id; or of zones, rooms by place being part of `zone_of_room`. A scan sees a zone
/// when it sees a room of it (is_seen). O(sightings x pairs in sight x doors of a pair).
[[nodiscard]] Independence independence_of_rooms(std::span<const Sighting> sightings,
                                                 const GridMap& map, const Segmentation& rooms);
[[nodiscard]] Independence independence_of_zones(std::span<const Sighting> sightings,
                                                 const GridMap& map, const Segmentation& rooms,
                                                 std::span<const std::uint32_t> zone_of_room);

/// Of both. @pre the rooms are in zones
[[nodiscard]] IndependenceReport independence_of(std::span<const Sighting> sightings,
                                                 const GridMap& map, const Segmentation& rooms);

}  // namespace quadcut
