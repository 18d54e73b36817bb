// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/route/sight.hpp"

namespace quadcut {

/// A place where a shortest way may bend, or has to pass. Bit 0 .. 3 of `blocked`: the cell to its
/// lower left, lower right, upper left, upper right is an obstacle's corner; a way bends there only
/// around one of them. None: a crossing, where ways come and go as they like.
struct WayNode {
    Cell cell;
    std::uint8_t blocked = 0;
};

/// The corners of each room, by label - 1: the cells where the robot fits, and fits beside an
/// obstacle on both sides of its corner; a cell further off where it fits there, too. Row by row.
/// O(cells).
[[nodiscard]] std::vector<std::vector<WayNode>> find_corners(const RobotFloor& floor,
                                                             std::size_t num_rooms);

/// The side of a hub's tile, cells.
inline constexpr std::int32_t kHubTile = 16;

/// The hubs of each room, by label - 1: of each tile the cell of the room with the largest
/// clearance. Row by row of tiles. O(cells).
[[nodiscard]] std::vector<std::vector<Cell>> find_hubs(const RobotFloor& floor,
                                                       std::size_t num_rooms);

/// Whether a shortest way may leave the node towards a cell, or come from there.
[[nodiscard]] bool is_taut(const WayNode& node, Cell towards);

/// The shortest ways within a room (Lozano-Pérez and Wesley's visibility graph, 1979): straight
/// lines from node to node, and from each crossing the lengths to all nodes. Ways begin and end at
/// hubs, and go through none. Lengths in cells.
struct RoomGraph {
    struct Edge {
        std::uint32_t to = 0;
        float length = 0.0F;
    };
    /// Crossings, corners, hubs.
    std::vector<WayNode> nodes;
    std::size_t num_crossings = 0;
    std::size_t first_hub = 0;
    /// Those of node i, none of them to a hub, are edges[first_edge[i]] .. edges[first_edge[i + 1]
    /// - 1].
    std::vector<std::size_t> first_edge;
    std::vector<Edge> edges;
    /// From crossing c to node i at c * nodes.size() + i, infinite where there is no way, and the
    /// node before it on that way.
    std::vector<float> lengths;
    std::vector<std::uint32_t> previous;
    std::size_t num_cells_read = 0;

    [[nodiscard]] std::size_t entry(std::size_t crossing, std::size_t node) const {
        return crossing * nodes.size() + node;
    }
};

/// O(nodes² · line + crossings · edges). `hubs` as find_hubs() gives them.
[[nodiscard]] RoomGraph build_room_graph(const RobotFloor& floor, std::vector<WayNode> crossings,
                                         const std::vector<WayNode>& corners,
                                         const std::vector<Cell>& hubs);

}  // namespace quadcut
