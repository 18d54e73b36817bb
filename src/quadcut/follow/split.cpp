// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Which room a line that people draw cuts.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/edits.hpp"
#include "quadcut/follow/split_line.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

/// So far from a room a line may be.
constexpr double kNearM = 3.0;
/// Two decimals tell the middle of a cell of this size from the next cell.
constexpr double kTwoDecimalsM = 0.02;

std::string text_of(const Point& point, double resolution_m) {
    const int decimals = resolution_m < kTwoDecimalsM ? 4 : 2;
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "(%.*f, %.*f)", decimals, point.x, decimals, point.y);
    return text.data();
}

Point middle_of(const Point& a, const Point& b) { return {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0}; }

/// The point of a line that is nearest to a cell's middle, and half a cell before.
Point before(const Point& from, const Point& to, Cell cell) {
    const double length = std::max(distance(from, to), 1e-9);
    const Point way{(to.x - from.x) / length, (to.y - from.y) / length};
    const Point off{cell.x + 0.5 - from.x, cell.y + 0.5 - from.y};
    return along(from, way, off.x * way.x + off.y * way.y - 0.5);
}

/// The part of a line that lies in one room and in the walls there; in cells.
struct RoomStretch {
    std::uint32_t room = 0;
    std::size_t num_cells = 0;
    Cell first;
    Cell last;
};

/// The longest stretch of the line in any room; nothing when it meets none.
RoomStretch stretch_of(const FollowedMap& followed, const Point& from, const Point& to) {
    RoomStretch longest;
    RoomStretch stretch;
    walk_line(from, to, [&](Cell cell, double) {
        const std::uint32_t room = followed.cells.room(cell);
        if (room == 0) return true;
        if (room != stretch.room) stretch = {room, 0, cell, cell};
        stretch.last = cell;
        if (++stretch.num_cells > longest.num_cells) longest = stretch;
        return true;
    });
    return longest;
}

/// The nearest room within kNearM; 0 = none.
std::uint32_t nearest_room(const FollowedMap& followed, Cell to) {
    std::uint32_t nearest = 0;
    double least = kNearM / followed.map.resolution_m();
    for_each_cell(Box{to, to}.grown(followed.in_cells(kNearM)), [&](Cell cell) {
        const double length = std::hypot(cell.x - to.x, cell.y - to.y);
        if (followed.cells.room(cell) == 0 || length >= least) return;
        least = length;
        nearest = followed.cells.room(cell);
    });
    return nearest;
}

}  // namespace

Reversal change_of_split(FollowedMap& followed, const Edit& edit) {
    const Point from = edit.from;
    const Point to = edit.to;
    const double resolution_m = followed.map.resolution_m();
    // Throws for points that are nowhere.
    static_cast<void>(followed.map.cell_at(from));
    static_cast<void>(followed.map.cell_at(to));
    Point begin{from.x / resolution_m, from.y / resolution_m};
    Point end{to.x / resolution_m, to.y / resolution_m};
    RoomStretch stretch = stretch_of(followed, begin, end);
    if (stretch.room != 0) {
        const Point first = before(begin, end, stretch.first);
        end = before(end, begin, stretch.last);
        begin = first;
    } else {
        stretch.room = nearest_room(followed, cell_of(middle_of(begin, end)));
    }
    if (stretch.room == 0) {
        throw InputError("no room is within 3 m of " + text_of(middle_of(from, to), resolution_m) +
                         ", the middle of the line");
    }
    const RoomId room{stretch.room};
    const std::string name = name_of(room);
    if (followed.rooms.at(stretch.room).is_locked) {
        throw InputError(name + " is locked: it keeps its border");
    }
    const Raster<std::uint8_t> mask = mask_of(followed, stretch.room);
    const SplitPlan plan = plan_split(mask, begin, end, resolution_m);
    if (!plan.line) {
        const auto legal = nearest_split(mask, begin, end, resolution_m);
        const auto at = [&](Cell cell) {
            return text_of({(cell.x + 0.5) * resolution_m, (cell.y + 0.5) * resolution_m},
                           resolution_m);
        };
        throw InputError(
            name + " cannot be cut there: " + plan.reason +
            (legal ? "; the nearest cut is from " + at(legal->from) + " to " + at(legal->to)
                   : "; within 3 m it can be cut nowhere"));
    }
    Reversal change;
    change.room = room;
    change.other = RoomId{take_id(followed)};
    change.border = Reversal::Border::part;
    if (followed.rooms.at(stretch.room).merge_group != 0) {
        change.settings[followed.next_id - 1].merge_group = followed.next_id - 1;
    }
    for (const Cell cell : plan.part) {
        change.cells[{tile_of(cell).x, tile_of(cell).y}] |= std::uint64_t{1} << place_in_tile(cell);
    }
    change.lines = {*plan.line};
    return change;
}

}  // namespace quadcut
