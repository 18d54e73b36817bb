// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/options.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

struct FollowedMap;

/// The room that a point is in, or else the nearest one; 0 = there is none.
struct Place {
    RoomId room{};
    std::string name;
    bool is_inside = false;
    double distance_m = 0.0;
};

/// A building as it was at one moment, which never changes: any number of threads may ask it. What
/// is dear is made when it is first asked for, once.
class Snapshot {
public:
    /// What became of a followed building, told when it is asked for, by any thread.
    struct Story {
        std::function<std::string()> updates;
        std::function<std::vector<Point>()> way;
    };

    /// A finished map. @pre the rooms are of its cells
    Snapshot(GridMap map, Segmentation rooms);
    /// A followed one; the options and threads are those that it is followed with.
    Snapshot(FollowedMap followed, const FollowOptions& options, const Executor& executor,
             Story story);
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;
    ~Snapshot();

    [[nodiscard]] std::uint64_t revision() const;
    [[nodiscard]] std::size_t num_rooms() const;
    /// All that is known of a followed building (followed_map.hpp); nothing for a finished map.
    [[nodiscard]] const FollowedMap* followed() const;
    /// Empty before anything was seen. O(map) when first called.
    [[nodiscard]] const GridMap& map() const;
    /// With doors; without a report where it is a followed map. O(map) when first called. Throws
    /// InputError when there are more rooms than labels.
    [[nodiscard]] const Segmentation& rooms() const;
    /// The lines of updates.jsonl.
    [[nodiscard]] std::string updates() const;
    /// Where the scans were taken that were added since the project was opened.
    [[nodiscard]] std::vector<Point> way() const;
    /// The room at a point of the map frame; 0 = none. O(1).
    [[nodiscard]] RoomId room_at(const Point& point) const;
    /// O(map) outside of the rooms that have a name.
    [[nodiscard]] Place place_of(const Point& point) const;
    /// The room that a word means: by its id, or by the name that is displayed. Throws InputError
    /// when there is none, or when it is the id of one and the name of another. O(map) when it is
    /// no id and no name that people gave.
    [[nodiscard]] RoomId find_room(const std::string& word) const;

private:
    [[nodiscard]] bool has_room(RoomId id) const;
    /// The room that people gave a name to; 0 = none.
    [[nodiscard]] RoomId given_to(const std::string& name) const;

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace quadcut
