// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "project/snapshot.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/route/route_planner.hpp"

namespace quadcut {

/// One end of a way, as it was given.
struct RouteEnd {
    /// As in the help: FROM or TO.
    std::string what;
    std::string word;
    /// Metres, map frame: of a room its label point.
    Point point;
    /// 0: it is a point.
    RoomId room{};
};

/// "X,Y" is a point, all else the id or name of a room. Throws InputError when no room or several
/// have that name; it says which may be meant.
[[nodiscard]] RouteEnd route_end(const std::string& what, const std::string& word,
                                 const Snapshot& building);

/// Where a robot stands there: a point too near to a wall is moved by as much as half a metre,
/// with a warning. Throws InputError where no robot can stand: in a wall, or where it is too wide.
[[nodiscard]] Cell standing_place(const RouteEnd& end, const Snapshot& building,
                                  const RoutePlanner& planner);

}  // namespace quadcut
