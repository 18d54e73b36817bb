// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>

#include "quadcut/base/random.hpp"
#include "sim/plan.hpp"
#include "sim/skeleton.hpp"
#include "sim/strip.hpp"

namespace quadcut::sim {

/// A place in a row along a corridor: [begin, end] x [0, depth] of `frame`, between faces. The
/// corridor lies below y = -style.corridor_wall_m; doors to it lie between front_begin and
/// front_end.
struct Lot {
    Frame frame;
    double begin = 0.0;
    double end = 0.0;
    double depth = 0.0;
    double front_begin = 0.0;
    double front_end = 0.0;
    std::size_t corridor = 0;

    [[nodiscard]] double length() const { return end - begin; }
    /// Whether the corridor runs along all of it.
    [[nodiscard]] bool is_fronted() const { return front_begin <= begin && front_end >= end; }
};

/// Builds rooms into lots. Each call adds one group of rooms with its doors.
class UnitBuilder {
public:
    UnitBuilder(Plan& plan, const WingStyle& style, Trade trade, Random& random)
        : plan_(plan), style_(style), trade_(trade), random_(random) {}

    /// One room with a door to the corridor; what it is for follows from its size.
    std::size_t add_room(const Lot& lot);
    /// A room around a small one in its front corner: storage with its own door, or a bathroom
    /// that is entered from the room.
    void add_room_around(const Lot& lot);
    /// A back room that is reached through the front room.
    void add_deep_suite(const Lot& lot);
    /// A room that is reached through the one beside it.
    void add_side_suite(const Lot& lot);
    /// A washroom with toilets at its back and a duct behind them.
    void add_washroom(const Lot& lot);
    /// Cubicles on both sides of an aisle at right angles to the corridor.
    void add_aisle(const Lot& lot);
    /// An open office with cubicles along its back wall.
    void add_cubicle_row(const Lot& lot);
    /// A kitchen or a lounge without a door leaf.
    void add_open_room(const Lot& lot);
    /// Stairs and lifts: no floor at all.
    void add_core(const Lot& lot);
    /// A door between two rooms that lie side by side in a row, at `x` where the first one ends.
    void join(std::size_t left, std::size_t right, const Lot& right_lot);

private:
    std::size_t add_sized_room(const Lot& lot, const Rect& rect);
    [[nodiscard]] Rect front_opening(double middle, double width) const;
    void add_front_door(const Lot& lot, std::size_t room, double low, double high);
    void add_cubicles(const Frame& row, double length, double depth, std::size_t aisle);
    void add_pillars(const Frame& frame, const Rect& rect);
    [[nodiscard]] double door_width();
    [[nodiscard]] double door_place(double low, double high, double width);

    Plan& plan_;
    const WingStyle& style_;
    Trade trade_;
    Random& random_;
};

/// What a room of this size is used for.
[[nodiscard]] RoomUse choose_use(Trade trade, double area_m2, Random& random);

}  // namespace quadcut::sim
