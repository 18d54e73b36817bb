// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/route/gates.hpp"
#include "quadcut/route/room_graph.hpp"
#include "quadcut/route/sight.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// A round robot of this diameter gets through most doors.
inline constexpr double kRobotWidthM = 0.4;

/// Where a way goes from one room into another.
struct RouteStep {
    RoomId from{};
    RoomId to{};
    /// The place of the door among the doors of the result; none where the border has no door.
    std::optional<std::size_t> door;
    /// Where the way crosses the border, map frame, and how far from its start that is.
    Point at;
    double after_m = 0.0;
};

/// A way for a robot: straight from point to point, in the map frame.
struct Route {
    std::vector<Point> points;
    double length_m = 0.0;
    /// Where it begins, and the rooms that it goes through after that.
    RoomId first_room{};
    std::vector<RouteStep> steps;
    /// What was read to find it: cells of the map, and lengths within rooms and nodes of their
    /// graphs.
    std::size_t num_cells_read = 0;
    std::size_t num_entries_read = 0;
};

/// Finds ways through a building that is cut into rooms: over rooms and doors first, then within
/// each room. Of a room it keeps what it had to find out, so that the next way through it is found
/// with a look at a few cells. A way is the shortest, within about a percent, that keeps the
/// robot's radius off walls and furniture; where there is space it bends 0.15 m
/// further off.
class RoutePlanner {
public:
    /// What `map` has as occupied is in the way; one without states only says where the cells lie.
    /// Both are kept by reference. O(cells). @pre robot_width_m >= 0
    RoutePlanner(const GridMap& map, const Segmentation& rooms, double robot_width_m = kRobotWidthM,
                 const Executor& executor = {});

    /// Finds out about all rooms at once; else it is done room by room when a way may lead there.
    void prepare(const Executor& executor = {});

    /// The cell nearest to a point where the robot can stand: in the room of the point, at most
    /// `within_m` away. None when the point is in no room.
    [[nodiscard]] std::optional<Cell> standing_place(const Point& point, double within_m) const;
    /// The middle of a cell, map frame.
    [[nodiscard]] Point middle_of(Cell cell) const;
    /// Whether the robot can get from one to the other. O(log). @pre standing places
    [[nodiscard]] bool is_connected(Cell from, Cell to) const;
    /// None when it cannot. @pre standing places
    [[nodiscard]] std::optional<Route> find(Cell from, Cell to);

    [[nodiscard]] const RobotFloor& floor() const { return floor_; }
    /// Cells read, and bytes kept, to know what is known of rooms now.
    [[nodiscard]] std::size_t num_cells_prepared() const;
    [[nodiscard]] std::size_t bytes() const;

private:
    friend class RouteSearch;

    /// A crossing as one of a room's: which gate, which place of its border, and which of its two
    /// cells lies in the room.
    struct Crossing {
        std::uint32_t gate = 0;
        std::uint32_t place = 0;
        std::uint32_t side = 0;
        /// The same crossing among those of the room on the other side.
        std::uint32_t beyond = 0;
    };

    [[nodiscard]] const RoomGraph& graph_of(std::size_t room);
    [[nodiscard]] RoomGraph build_graph(std::size_t room) const;
    /// Nodes of the room's graph: its hubs of the tile of a cell and of the tiles around, the
    /// nearest first.
    [[nodiscard]] std::vector<std::uint32_t> hubs_around(Cell cell, std::size_t room) const;

    const GridMap& map_;
    const Segmentation& rooms_;
    RobotFloor floor_;
    ConnectedParts parts_;
    std::vector<Gate> gates_;
    /// By room, that is label - 1.
    std::vector<std::vector<Crossing>> crossings_;
    std::vector<std::vector<WayNode>> corners_;
    std::vector<std::vector<Cell>> hubs_;
    std::vector<std::optional<RoomGraph>> graphs_;
};

}  // namespace quadcut
