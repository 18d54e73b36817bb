// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

struct ClosureOptions {
    /// As far as the sensor sees: poses farther apart have nothing in common.
    double range_m = 30.0;
    /// Poses in rooms that share an opening are worth matching when the way from one to the other
    /// through its nearest cells is no longer than this.
    double through_opening_m = 5.0;
    /// What the robot must have travelled since an earlier pose: before that the scans are matched
    /// one after the other anyway.
    double least_way_m = 10.0;
};

/// Which earlier poses are worth matching with a new one, for a SLAM back end that closes loops:
/// those in its own room, and those beyond an opening that both stand near. Poses that are in no
/// room, nor within 0.5 m of one, are compared with all.
class ClosureIndex {
public:
    /// The rooms and their frame (its states are not read) are kept by reference. O(cells).
    ClosureIndex(const GridMap& frame, const Segmentation& rooms,
                 const ClosureOptions& options = {});

    /// The number of this pose, from 0 on: where the robot was next, metres, map frame. O(its
    /// neighbour rooms).
    std::size_t add(const Point& pose);
    /// The earlier poses, ascending, that are worth matching with one that was added. O(poses in
    /// its room and in those that share an opening with it).
    [[nodiscard]] std::vector<std::size_t> candidates(std::size_t pose) const;

private:
    /// An opening of a room, and what lies beyond.
    struct Opening {
        std::uint16_t room = 0;
        /// In cells.
        std::vector<Point> border;
    };
    struct Placed {
        /// In cells.
        Point at;
        double way_m = 0.0;
        /// Label; 0 = in none.
        std::uint16_t room = 0;
        /// How far each of the room's openings is, metres.
        std::vector<float> opening_m;
    };

    [[nodiscard]] std::uint16_t room_near(const Point& at) const;
    [[nodiscard]] bool is_worth(const Placed& earlier, const Placed& later) const;

    const GridMap& frame_;
    const Segmentation& rooms_;
    ClosureOptions options_;
    /// By label; each opening is one of both its rooms.
    std::vector<std::vector<Opening>> openings_;
    /// By label: the poses there.
    std::vector<std::vector<std::size_t>> poses_in_;
    std::vector<Placed> poses_;
};

}  // namespace quadcut
