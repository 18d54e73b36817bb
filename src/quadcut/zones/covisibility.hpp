// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "quadcut/segment/result.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// A scan sees a room when it sees so much of its floor, or half of it if that is less: what comes
/// through the gap of a door, or beside a wall that a robot's pose is wrong about, is no sight of
/// it.
inline constexpr double kLeastSeenM2 = 1.0;

[[nodiscard]] constexpr bool is_seen(double seen_m2, double room_m2) {
    return seen_m2 > 0.0 && (seen_m2 >= kLeastSeenM2 || seen_m2 >= room_m2 / 2.0);
}

/// How many scans saw a room, and two rooms both. Rooms are told by any numbers that are theirs
/// alone: mostly their ids.
struct Covisibility {
    std::map<std::uint32_t, std::size_t> scans_of_room;
    /// The lower number first; none where no scan saw both.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> scans_of_pair;

    [[nodiscard]] std::size_t num_seeing(std::uint32_t room) const;
    [[nodiscard]] std::size_t num_seeing_both(std::uint32_t a, std::uint32_t b) const;
    /// Scans that see one of them, or both.
    [[nodiscard]] std::size_t num_seeing_either(std::uint32_t a, std::uint32_t b) const;
    friend bool operator==(const Covisibility&, const Covisibility&) = default;
};

/// Counts one scan. `rooms` that it sees, ascending, each once. O(n^2 log) for n of them.
void count_scan(Covisibility& counts, std::span<const std::uint32_t> rooms);

/// Room `ended` is a part of room `now` from here on. Scans of the room are exact; those of its
/// pairs are a sum, at most what scans of the two rooms there can be: which scans saw both parts
/// beside a third room is not kept.
void join_rooms(Covisibility& counts, std::uint32_t ended, std::uint32_t now);

/// Room `ended` is no more.
void forget_room(Covisibility& counts, std::uint32_t ended);

/// Rooms by place; counts by their ids. The weight of two rooms is the number of scans that see
/// both, divided by the number that see one of them or both (0 .. 1): what a robot did longest does
/// not outweigh the rest of the building. O(rooms + pairs log).
[[nodiscard]] Graph covisibility_graph(const Covisibility& counts, const Segmentation& rooms);

}  // namespace quadcut
