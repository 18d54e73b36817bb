// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "draw/filmstrip.hpp"
#include "quadcut/follow/follower.hpp"
#include "reproduce/world.hpp"

namespace quadcut::reproduce {

/// What following a world's scans gave, and what cutting its map anew gives: the paper's
/// incremental and basic algorithms.
struct Followed {
    std::vector<FollowUpdate> updates;
    /// Over scans: the free leaves of the whole map, the size of the basic algorithm's matrix.
    std::vector<Point> whole_leaves;
    /// Over scans: the nodes that an update cut, and its wall time in milliseconds.
    std::vector<Point> cut_nodes;
    std::vector<Point> cut_ms;
    /// At equal numbers of scans; the last is the end.
    std::vector<draw::Moment> moments;
    /// At each moment, over scans: the same map cut anew, its nodes and its time.
    std::vector<Point> basic_nodes;
    std::vector<Point> basic_ms;
    /// The last of them.
    Segmentation at_once;

    [[nodiscard]] const GridMap& map() const { return moments.back().map; }
    [[nodiscard]] const Segmentation& rooms() const { return moments.back().rooms; }
};

/// @pre the world has scans; num_moments > 0.
[[nodiscard]] Followed follow(const World& world, const SegmentOptions& options,
                              const RunOptions& run, double resolution_m, std::size_t num_moments);

/// Rooms that no straight line from one point of the way to the next meets: no part of the map, the
/// paper says. O(way + rooms).
[[nodiscard]] std::size_t count_uncrossed(const draw::Moment& moment);

/// The heights of a curve.
[[nodiscard]] std::vector<double> heights(const std::vector<Point>& points);
/// Of the heights; 0 of none.
[[nodiscard]] double mean(const std::vector<Point>& points);
/// The middle one of some values; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace quadcut::reproduce
