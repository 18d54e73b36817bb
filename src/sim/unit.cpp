// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/unit.hpp"

#include <algorithm>
#include <cmath>

namespace quadcut::sim {
namespace {

constexpr double kHallArea = 80.0;
// Between a door and the nearest corner.
constexpr double kJamb = 0.1;

RoomUse pick(Random& random, std::initializer_list<RoomUse> uses) {
    return uses.begin()[random.below(uses.size())];
}

// Through a wall between two heights.
Rect opening(double middle, double width, double low, double high) {
    return {middle - 0.5 * width, low, middle + 0.5 * width, high};
}

}  // namespace

RoomUse choose_use(Trade trade, double area_m2, Random& random) {
    if (area_m2 > kHallArea) return RoomUse::hall;
    switch (trade) {
        case Trade::home:
            if (area_m2 < 4.5) return pick(random, {RoomUse::bathroom, RoomUse::storage});
            if (area_m2 < 9.0) return pick(random, {RoomUse::bathroom, RoomUse::kitchen});
            if (area_m2 < 18.0) {
                return pick(random, {RoomUse::bedroom, RoomUse::bedroom, RoomUse::kitchen,
                                     RoomUse::office});
            }
            return pick(random, {RoomUse::lounge, RoomUse::lounge, RoomUse::bedroom});
        case Trade::clinic:
            if (area_m2 < 6.0) return RoomUse::storage;
            if (area_m2 < 40.0)
                return pick(random, {RoomUse::ward, RoomUse::ward, RoomUse::office});
            return pick(random, {RoomUse::laboratory, RoomUse::lounge, RoomUse::ward});
        case Trade::school:
            if (area_m2 < 6.0) return RoomUse::storage;
            if (area_m2 < 28.0) return pick(random, {RoomUse::office, RoomUse::meeting});
            return pick(random, {RoomUse::classroom, RoomUse::classroom, RoomUse::laboratory});
        case Trade::office:
            break;
    }
    if (area_m2 < 6.0) return RoomUse::storage;
    if (area_m2 < 18.0) return RoomUse::office;
    if (area_m2 < 32.0) return pick(random, {RoomUse::office, RoomUse::office, RoomUse::meeting});
    return pick(random, {RoomUse::meeting, RoomUse::laboratory, RoomUse::open_office});
}

double UnitBuilder::door_width() {
    switch (trade_) {
        case Trade::home:
            return random_.uniform(0.75, 0.95);
        case Trade::clinic:
            return random_.uniform(0.95, 1.2);
        default:
            return random_.uniform(0.8, 1.05);
    }
}

// The middle of an opening between two walls: mostly near one of them, as doors are.
double UnitBuilder::door_place(double low, double high, double width) {
    const double first = low + kJamb + 0.5 * width;
    const double last = std::max(first, high - kJamb - 0.5 * width);
    const double gap = std::min(random_.uniform(0.0, 0.3), last - first);
    const double choice = random_.uniform();
    if (choice < 0.35) return first + gap;
    if (choice < 0.7) return last - gap;
    return random_.uniform(first, last + 1e-9);
}

// Through the wall to the corridor.
Rect UnitBuilder::front_opening(double middle, double width) const {
    return opening(middle, width, -style_.corridor_wall_m, 0.0);
}

// Most rooms are for what their size suggests.
std::size_t UnitBuilder::add_sized_room(const Lot& lot, const Rect& rect) {
    const RoomUse use = choose_use(trade_, rect.area(), random_);
    return plan_.add_room(use, lot.frame, rect, style_.outer_wall_m);
}

void UnitBuilder::add_front_door(const Lot& lot, std::size_t room, double low, double high) {
    low = std::max(low, lot.front_begin);
    high = std::min(high, lot.front_end);
    const double free = high - low - 2.0 * kJamb;
    double width = std::min(door_width(), free);
    const double area = plan_.rooms[room].parts.front().rect.area();
    const auto add = [&](double from, double to) {
        const double x = door_place(from, to, width);
        plan_.doors.push_back({lot.corridor, room, lot.frame, front_opening(x, width), false});
    };
    if (area > 40.0 && free > 2.2 && random_.uniform() < 0.6) width = random_.uniform(1.3, 1.7);
    if (area > 40.0 && high - low > 6.0 && random_.uniform() < 0.5) {
        const double middle = 0.5 * (low + high);
        add(low, middle);
        add(middle, high);
    } else {
        add(low, high);
    }
}

void UnitBuilder::add_pillars(const Frame& frame, const Rect& rect) {
    const double pitch = random_.uniform(4.5, 6.5);
    const double half = 0.5 * random_.uniform(0.3, 0.5);
    const bool round = random_.uniform() < 0.4;
    const auto rows = static_cast<int>(rect.height() / pitch + 0.3);
    const auto columns = static_cast<int>(rect.width() / pitch + 0.3);
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const Point p{rect.x0 + rect.width() * (j + 0.5) / columns,
                          rect.y0 + rect.height() * (i + 0.5) / rows};
            Polygon outline;
            const int corners = round ? 12 : 4;
            for (int k = 0; k < corners; ++k) {
                const double angle = 2.0 * M_PI * (k + 0.5) / corners;
                const double r = round ? half : half * std::sqrt(2.0);
                outline.push_back(
                    frame.map({p.x + r * std::cos(angle), p.y + r * std::sin(angle)}));
            }
            plan_.pillars.push_back(outline);
        }
    }
}

std::size_t UnitBuilder::add_room(const Lot& lot) {
    const Rect rect{lot.begin, 0.0, lot.end, lot.depth};
    const std::size_t room = add_sized_room(lot, rect);
    add_front_door(lot, room, lot.begin, lot.end);
    if (rect.area() > 65.0 && lot.depth > 5.5) add_pillars(lot.frame, rect);
    return room;
}

void UnitBuilder::add_room_around(const Lot& lot) {
    const bool entered_from_room = trade_ == Trade::clinic || trade_ == Trade::home;
    const double p = style_.partition_m;
    const double rest = random_.uniform(entered_from_room ? 1.3 : 1.7, 2.6);
    const double width = std::clamp(lot.length() - p - rest, 1.4, 2.4);
    const double depth = random_.uniform(1.5, std::min(2.5, lot.depth - 2.4));
    const bool at_left = random_.uniform() < 0.5;
    const double cut = at_left ? lot.begin + width : lot.end - width;
    const Rect small = at_left ? Rect{lot.begin, 0, cut, depth} : Rect{cut, 0, lot.end, depth};
    const Rect arm =
        at_left ? Rect{cut + p, 0, lot.end, depth + p} : Rect{lot.begin, 0, cut - p, depth + p};
    const Rect body{lot.begin, depth + p, lot.end, lot.depth};

    const RoomUse use = choose_use(trade_, arm.area() + body.area(), random_);
    const std::size_t room = plan_.add_room(use, lot.frame, body, style_.outer_wall_m);
    plan_.rooms[room].parts.push_back({lot.frame, arm});
    add_front_door(lot, room, arm.x0, arm.x1);

    const std::size_t inner =
        plan_.add_room(entered_from_room ? RoomUse::bathroom : RoomUse::storage, lot.frame, small,
                       style_.outer_wall_m);
    if (!entered_from_room) {
        add_front_door(lot, inner, small.x0, small.x1);
        return;
    }
    const double opening_width = random_.uniform(0.7, 0.85);
    const double y = door_place(0.0, depth, opening_width);
    const double wall = at_left ? cut : cut - p;
    plan_.doors.push_back({at_left ? inner : room, at_left ? room : inner, lot.frame.swapped(),
                           opening(y, opening_width, wall, wall + p), false});
}

void UnitBuilder::add_deep_suite(const Lot& lot) {
    const double p = style_.partition_m;
    const double cut = random_.uniform(2.5, lot.depth - p - 2.6);
    const Rect front{lot.begin, 0, lot.end, cut};
    const Rect back{lot.begin, cut + p, lot.end, lot.depth};
    const std::size_t a = add_sized_room(lot, front);
    const std::size_t b = add_sized_room(lot, back);
    add_front_door(lot, a, lot.begin, lot.end);
    const double width = door_width();
    const double x = door_place(lot.begin, lot.end, width);
    plan_.doors.push_back({a, b, lot.frame, opening(x, width, cut, cut + p), false});
}

void UnitBuilder::join(std::size_t left, std::size_t right, const Lot& right_lot) {
    const double width = door_width();
    const double y = door_place(0.0, right_lot.depth, width);
    plan_.doors.push_back({left, right, right_lot.frame.swapped(),
                           opening(y, width, right_lot.begin - style_.partition_m, right_lot.begin),
                           false});
}

void UnitBuilder::add_side_suite(const Lot& lot) {
    const double share = random_.uniform(0.4, 0.6);
    Lot left = lot;
    left.end = lot.begin + share * lot.length();
    Lot right = lot;
    right.begin = left.end + style_.partition_m;
    const std::size_t a = add_sized_room(lot, {left.begin, 0, left.end, left.depth});
    const std::size_t b = add_sized_room(lot, {right.begin, 0, right.end, right.depth});
    if (random_.uniform() < 0.5) {
        add_front_door(left, a, left.begin, left.end);
    } else {
        add_front_door(right, b, right.begin, right.end);
    }
    join(a, b, right);
}

void UnitBuilder::add_washroom(const Lot& lot) {
    const double p = 0.1;
    const double stall_depth = random_.uniform(1.7, 2.0);
    const double lobby = std::min(random_.uniform(1.7, 2.6), lot.depth - stall_depth - p);
    const auto count = static_cast<int>(std::max(1.0, (lot.length() + p) / (1.25 + p)));
    const double width = (lot.length() + p) / count - p;
    const std::size_t room = plan_.add_room(RoomUse::washroom, lot.frame,
                                            {lot.begin, 0, lot.end, lobby}, style_.outer_wall_m);
    add_front_door(lot, room, lot.begin, lot.end);
    for (int i = 0; i < count; ++i) {
        const double x = lot.begin + i * (width + p);
        const std::size_t stall =
            plan_.add_room(RoomUse::toilet, lot.frame,
                           {x, lobby + p, x + width, lobby + p + stall_depth}, style_.outer_wall_m);
        const double door = random_.uniform(0.7, 0.75);
        const double middle = door_place(x, x + width, door);
        plan_.doors.push_back(
            {room, stall, lot.frame, opening(middle, door, lobby, lobby + p), false});
    }
    const double duct = lobby + p + stall_depth + style_.partition_m;
    if (lot.depth - duct > 0.3) {
        plan_.shafts.push_back({to_polygon(lot.frame, {lot.begin, duct, lot.end, lot.depth}),
                                random_.uniform() < 0.4});
    }
}

// Cubicles along an aisle; in `row` they lie above y = 0, the aisle below the partition.
void UnitBuilder::add_cubicles(const Frame& row, double length, double depth, std::size_t aisle) {
    constexpr double kPartition = 0.08;
    constexpr double kMost = 2.7;
    const double wanted = random_.uniform(1.9, 2.5);
    int count = std::max(1, static_cast<int>((length + kPartition) / (wanted + kPartition)));
    if ((length + kPartition) / count - kPartition > kMost) ++count;
    const double width = (length + kPartition) / count - kPartition;
    // A quarter of the rows is open over its whole width, the others have stubs at their fronts.
    const bool has_stubs = random_.uniform() < 0.75;
    const double spare = std::min(width - 1.3, 1.0);
    const double left = has_stubs ? random_.uniform(0.25, 0.5) * spare : 0.0;
    const double right = has_stubs ? random_.uniform(0.1, 0.5) * spare : 0.0;
    for (int i = 0; i < count; ++i) {
        const double x = i * (width + kPartition);
        const std::size_t room =
            plan_.add_room(RoomUse::cubicle, row, {x, 0, x + width, depth}, style_.outer_wall_m);
        plan_.doors.push_back(
            {aisle, room, row, {x + left, -kPartition, x + width - right, 0}, true});
    }
}

void UnitBuilder::add_aisle(const Lot& lot) {
    constexpr double kPartition = 0.08;
    const double aisle = random_.uniform(1.6, 2.2);
    const double depth = 0.5 * (lot.length() - aisle - 2.0 * kPartition);
    const double left = lot.begin + depth + kPartition;
    const std::size_t room = plan_.add_room(
        RoomUse::aisle, lot.frame, {left, 0, left + aisle, lot.depth}, style_.outer_wall_m);
    const bool open = random_.uniform() < 0.5;
    const double width = open ? random_.uniform(1.2, aisle - 0.25) : door_width();
    const double x = left + 0.5 * aisle;
    plan_.doors.push_back({lot.corridor, room, lot.frame, front_opening(x, width), open});
    const Point v = lot.frame.v;
    const Point u = lot.frame.u;
    add_cubicles({lot.frame.map({lot.begin + depth, 0}), v, {-u.x, -u.y}}, lot.depth, depth, room);
    add_cubicles({lot.frame.map({left + aisle + kPartition, 0}), v, u}, lot.depth, depth, room);
}

void UnitBuilder::add_cubicle_row(const Lot& lot) {
    constexpr double kPartition = 0.08;
    const double depth = random_.uniform(2.0, 2.4);
    const double front = lot.depth - depth - kPartition;
    const Rect rect{lot.begin, 0, lot.end, front};
    const std::size_t room =
        plan_.add_room(rect.area() > kHallArea ? RoomUse::hall : RoomUse::open_office, lot.frame,
                       rect, style_.outer_wall_m);
    add_front_door(lot, room, lot.begin, lot.end);
    add_cubicles(lot.frame.at({lot.begin, front + kPartition}), lot.length(), depth, room);
}

void UnitBuilder::add_open_room(const Lot& lot) {
    const Rect rect{lot.begin, 0, lot.end, lot.depth};
    const RoomUse use = rect.area() < 16.0 ? RoomUse::kitchen : RoomUse::lounge;
    const std::size_t room = plan_.add_room(use, lot.frame, rect, style_.outer_wall_m);
    const double low = std::max(lot.begin, lot.front_begin);
    const double high = std::min(lot.end, lot.front_end);
    const double width = std::min(random_.uniform(1.2, 2.0), high - low - 0.6);
    const double x = door_place(low + 0.1, high - 0.1, width);
    plan_.doors.push_back({lot.corridor, room, lot.frame, front_opening(x, width), true});
}

void UnitBuilder::add_core(const Lot& lot) {
    const double p = style_.outer_wall_m;
    plan_.shafts.push_back({to_polygon(lot.frame, {lot.begin + p, p, lot.end - p, lot.depth - p}),
                            random_.uniform() < 0.4});
}

}  // namespace quadcut::sim
