// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/route/route_planner.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// A way and what it leads through, as it is written.
struct WrittenRoute {
    const Route& route;
    const Segmentation& rooms;
    const GridMap& frame;
    double robot_width_m = 0.0;
};

/// For people: how long it is, then the rooms with a line each, and by which door they are entered;
/// where there are zones, a line before the first room of each.
[[nodiscard]] std::string route_as_text(const WrittenRoute& written);
/// An object: length_m, rooms, doors and points; metres, map frame.
[[nodiscard]] std::string route_as_json(const WrittenRoute& written);
/// A FeatureCollection of one LineString, whose properties are those of route_as_json().
[[nodiscard]] std::string route_as_geojson(const WrittenRoute& written);

/// The same where there is no way, and why.
struct WrittenReason {
    std::string reason;
    double robot_width_m = 0.0;
};

/// The reason, a line.
[[nodiscard]] std::string reason_as_text(const WrittenReason& written);
/// length_m is null, and there is the reason.
[[nodiscard]] std::string reason_as_json(const WrittenReason& written);
/// No feature, but the reason.
[[nodiscard]] std::string reason_as_geojson(const WrittenReason& written);

}  // namespace quadcut::io
