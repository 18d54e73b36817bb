// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "quadcut/segment/result.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// Floor of a room that a scan saw. Rooms are told by any number that is theirs alone.
struct SeenFloor {
    std::uint32_t room = 0;
    std::uint32_t num_cells = 0;
    friend bool operator==(const SeenFloor&, const SeenFloor&) = default;
};

/// Scans that see both of two rooms: each scan counts one in all, and is shared out by the floor
/// that it sees. Of a scan that sees the share p of its floor in room a and q in room b, the pair
/// has p q (twice: as a, b and as b, a), and a with itself p^2.
struct Covisibility {
    /// The lower number first; none where no scan sees both. A room with itself, too.
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> scans;
    friend bool operator==(const Covisibility&, const Covisibility&) = default;
};

/// Counts a scan, by what it sees of each room. O(n^2 log pairs) for n rooms.
void count_scan(Covisibility& counts, std::span<const SeenFloor> floors);

/// Room `ended` is a part of room `now` from here on. Exact: as if it had always been.
void join_rooms(Covisibility& counts, std::uint32_t ended, std::uint32_t now);

/// G_submap by co-visibility: rooms by place, counts by their ids. Weights as they are counted, the
/// self-loops among them (rule 1 of the paper: relevance in itself): of a normalised cut of this
/// graph, what is cut of a zone's weight is what scans see elsewhere (docs/decisions/0021).
/// O(rooms + pairs log rooms).
[[nodiscard]] Graph covisibility_graph(const Covisibility& counts, const Segmentation& rooms);

}  // namespace quadcut
