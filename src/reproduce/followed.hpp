// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "draw/filmstrip.hpp"
#include "quadcut/follow/follower.hpp"
#include "reproduce/world.hpp"

namespace quadcut::reproduce {

/// Following in the preset `paper` is done on cells of this side, metres: graphs are then as large
/// as those that the paper speaks of, some hundred nodes.
inline constexpr double kPaperFollowResolutionM = 0.2;

/// What following a world's scans gave.
struct Followed {
    std::vector<FollowUpdate> updates;
    /// Over scans: the free leaves of the whole map, the size of the basic algorithm's matrix.
    std::vector<Point> whole_nodes;
    /// Over scans: the size of the matrix that an update cut.
    std::vector<Point> local_nodes;
    /// The wall time of each cut, milliseconds, in order of their scans.
    std::vector<double> cuts_ms;
    /// At equal numbers of scans; the last is the end.
    std::vector<draw::Moment> moments;

    [[nodiscard]] const GridMap& map() const { return moments.back().map; }
    [[nodiscard]] const Segmentation& rooms() const { return moments.back().rooms; }
};

/// @pre the world has scans; num_moments > 0.
[[nodiscard]] Followed follow(const World& world, const SegmentOptions& options,
                              const RunOptions& run, double resolution_m, std::size_t num_moments);

/// The middle one of some values; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace quadcut::reproduce
