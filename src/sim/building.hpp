// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/result.hpp"
#include "sim/shape.hpp"

namespace quadcut::sim {

struct Plan;

/// What a simulated building is to be like.
struct BuildingOptions {
    std::uint64_t seed = 1;
    /// Rooms, corridors and halls together, 3..1000; the building has about as many.
    int num_rooms = 20;
    /// 0: empty, 1: every place is taken. What stands at a lower density stands at a higher one.
    double furniture = 0.5;
    /// 0.02..0.1
    double resolution_m = 0.05;
    /// How often a wing is turned by 15 to 40 degrees against the one that it joins, 0..1. Only
    /// buildings of more than about 15 rooms have several wings.
    double turned_wings = 0.5;
    /// 0: as many wings as the rooms need, each joined to another by its corridor. 2..20: a campus
    /// of so many, as far as there is space, joined by walkways with a door at either end.
    int num_wings = 0;
    /// Direction of the whole building.
    double yaw_rad = 0.0;
    /// The share of doors whose leaf stands open in the room, 0..1.
    double open_leaves = 0.3;
    /// 0: furniture as architects draw it, with ways for a robot; 1: as people leave it, in rows
    /// and islands, along corridors and beside doors, chairs pushed about.
    double clutter = 0.0;
    /// 0: rooms have doors; 1: corridors end in lobbies and round halls that they enter at their
    /// full width, and more than half of the rooms have an opening of up to 10 m.
    double openness = 0.0;
};

/// A place as people name it. Its floor is a union of convex polygons in the map frame, without
/// the doorways.
struct TrueRoom {
    RoomId id{};
    std::string name;
    RoomKind kind = RoomKind::room;
    /// Of its cells in `bare_labels`.
    double area_m2 = 0.0;
    std::vector<Polygon> floor;
    /// From 0; a corridor of several wings counts as of the first.
    int wing = 0;
};

/// A door or an open passage. The jambs are the ends of the middle line of the opening, that is
/// in the middle of the wall: the border between the two rooms.
struct TrueDoor {
    RoomId a{};
    RoomId b{};
    Point jamb_1;
    Point jamb_2;
    double width_m = 0.0;
    bool is_open_passage = false;
};

/// A building with its truth.
///
/// `map` is what a perfect survey would draw: floor free, walls and furniture occupied, unknown
/// outside and inside large pieces of furniture. `bare` is the same without furniture and door
/// leaves. Some shafts and yards, which nobody can enter, are drawn free; they are no rooms.
/// `labels` gives every free cell of `map` its room, 0 elsewhere and in shafts; `bare_labels` the
/// same for `bare`. The half of a doorway on either side of its middle line belongs to the room
/// on that side. Each room is connected (4-neighbours) in `bare_labels`.
struct Building {
    GridMap map;
    GridMap bare;
    Raster<std::uint16_t> labels;
    Raster<std::uint16_t> bare_labels;
    /// rooms[i] has the id i + 1.
    std::vector<TrueRoom> rooms;
    std::vector<TrueDoor> doors;
    int num_turned_wings = 0;
};

/// Draws a building: the same options give the same bytes. Throws InputError when an option is
/// out of its range. About 2 ms a room.
[[nodiscard]] Building generate_building(const BuildingOptions& options);

/// Draws and furnishes a plan. Uses seed, furniture, resolution and leaves of the options.
[[nodiscard]] Building draw_building(const Plan& plan, const BuildingOptions& options);

}  // namespace quadcut::sim
