// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What people change in followed rooms.
#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <string>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/segment/follow.hpp"
#include "quadcut/segment/split_line.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kMaxNameBytes = 200;

std::string text_of(const Point& point) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "(%.2f, %.2f)", point.x, point.y);
    return text.data();
}

const std::array<Cell, 4> kBeside{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Calls visit(cell) for the cells of a room.
template <typename Visit>
void for_each_cell(const RoomCells& cells, std::uint32_t room, const Box& box, const Visit& visit) {
    for (Cell cell = box.low; cell.y <= box.high.y; ++cell.y) {
        for (cell.x = box.low.x; cell.x <= box.high.x; ++cell.x) {
            if (cells.room(cell) == room) visit(cell);
        }
    }
}

}  // namespace

std::uint32_t Follower::existing(RoomId room) const {
    const auto number = static_cast<std::uint32_t>(room);
    if (rooms_.count(number) == 0) {
        throw InputError("there is no room " + std::to_string(number) + ": expected one of the " +
                         std::to_string(rooms_.size()) + " rooms that there are");
    }
    return number;
}

void Follower::rename(RoomId room, const std::string& name) {
    const std::uint32_t number = existing(room);
    const bool is_printable = std::none_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    });
    if (name.empty() || name.size() > kMaxNameBytes || !is_printable) {
        throw InputError("a room's name has 1 to 200 bytes and no control characters");
    }
    rooms_.at(number).name = name;
}

FollowUpdate Follower::merge(RoomId room, RoomId other) {
    const std::uint32_t into = existing(room);
    const std::uint32_t from = existing(other);
    if (into == from) throw InputError("a room cannot be merged with itself");
    if (rooms_.at(into).is_locked || rooms_.at(from).is_locked) {
        throw InputError("one of the rooms is locked: it keeps its border");
    }
    bool do_touch = false;
    const Box box = rooms_.at(from).box;
    for_each_cell(cells_, from, box, [&](Cell cell) {
        do_touch = do_touch || std::any_of(kBeside.begin(), kBeside.end(), [&](Cell step) {
                       return cells_.room({cell.x + step.x, cell.y + step.y}) == into;
                   });
    });
    if (!do_touch) {
        throw InputError("rooms " + std::to_string(into) + " and " + std::to_string(from) +
                         " do not touch: a room is connected");
    }
    remove_split_lines_between(into, from);
    for_each_cell(cells_, from, box, [&](Cell cell) { cells_.set_room(cell, into); });
    FollowedRoom& whole = rooms_.at(into);
    const FollowedRoom& part = rooms_.at(from);
    whole.num_cells += part.num_cells;
    whole.peak_m = std::max(whole.peak_m, part.peak_m);
    whole.box.include(part.box);
    const std::uint32_t group = whole.merge_group != 0 ? whole.merge_group : into;
    const std::uint32_t other_group = part.merge_group;
    whole.merge_group = group;
    whole.announced_m2 += part.announced_m2;
    rooms_.erase(from);
    for (auto& [id, followed] : rooms_) {
        if (other_group != 0 && followed.merge_group == other_group) followed.merge_group = group;
    }
    return by_hand(RoomLife::merged, from, into);
}

FollowUpdate Follower::split(const Point& from, const Point& to) {
    // Throws for points that are nowhere.
    static_cast<void>(map_.cell_at(from));
    static_cast<void>(map_.cell_at(to));
    const Point middle{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0};
    const std::uint32_t number = cells_.room(map_.cell_at(middle));
    if (number == 0) {
        throw InputError("no room is at " + text_of(middle) + ", the middle of the line");
    }
    FollowedRoom& room = rooms_.at(number);
    if (room.is_locked) {
        throw InputError("room " + std::to_string(number) + " is locked: it keeps its border");
    }
    Raster<std::uint8_t> mask(room.box);
    for_each_cell(cells_, number, room.box, [&](Cell cell) { mask.at(cell) = 1; });
    const double resolution_m = options_.resolution_m;
    const auto in_cells = [&](const Point& point) {
        return Point{point.x / resolution_m, point.y / resolution_m};
    };
    const SplitPlan plan = plan_split(mask, in_cells(from), in_cells(to), resolution_m);
    if (!plan.line) {
        const auto legal = nearest_split(mask, in_cells(from), in_cells(to), resolution_m);
        const auto at = [&](Cell cell) {
            return text_of({(cell.x + 0.5) * resolution_m, (cell.y + 0.5) * resolution_m});
        };
        throw InputError(
            "room " + std::to_string(number) + " cannot be cut there: " + plan.reason +
            (legal ? "; the nearest cut is from " + at(legal->from) + " to " + at(legal->to)
                   : "; within 3 m it can be cut nowhere"));
    }
    const std::uint32_t part = new_id();
    add_split_line(*plan.line);
    FollowedRoom& smaller = rooms_[part];
    if (room.merge_group != 0) smaller.merge_group = part;
    smaller.peak_m = room.peak_m;
    for (const Cell cell : plan.part) {
        cells_.set_room(cell, part);
        smaller.box.include({cell, cell});
    }
    smaller.num_cells = plan.part.size();
    room.num_cells -= plan.part.size();
    const double cell_m2 = resolution_m * resolution_m;
    smaller.announced_m2 = static_cast<double>(smaller.num_cells) * cell_m2;
    return by_hand(RoomLife::split, part, number);
}

FollowUpdate Follower::by_hand(RoomLife life, std::uint32_t room, std::uint32_t other) const {
    FollowUpdate update;
    update.scan = num_scans_;
    update.num_rooms = rooms_.size();
    update.num_leaves = map_.num_leaves();
    update.events.push_back({life, RoomId{room}, RoomId{other}, "by hand"});
    return update;
}

void Follower::lock(RoomId room) { rooms_.at(existing(room)).is_locked = true; }

void Follower::add_split_line(const SplitLine& line) {
    split_lines_.push_back(line);
    for (const Cell cell : cells_of(line)) split_cells_.emplace(cell.y, cell.x);
}

/// Who merges what was cut by hand takes that cut back: as a wall it would part them again.
void Follower::remove_split_lines_between(std::uint32_t room, std::uint32_t other) {
    split_cells_.clear();
    for (const SplitLine& line : std::exchange(split_lines_, {})) {
        std::set<std::uint32_t> beside;
        for (const Cell cell : cells_of(line)) {
            // The ends lie in walls, behind which other rooms may be.
            if (cells_.room(cell) == 0) continue;
            for (const Cell step : kBeside) {
                beside.insert(cells_.room({cell.x + step.x, cell.y + step.y}));
            }
        }
        beside.erase(0);
        if (beside != std::set<std::uint32_t>{room, other}) add_split_line(line);
    }
}

/// The cells of lines where people cut belong to the room beside them.
void Follower::fill_split_lines(const LocalWindow& window, LocalCut& cut) const {
    bool is_any = true;
    while (is_any) {
        is_any = false;
        for (const auto& [y, x] : split_cells_) {
            if (!window.states.contains({x, y}) || map_.state({x, y}) != CellState::free) continue;
            if (cut.regions.at({x, y}) != 0) continue;
            for (const Cell step : kBeside) {
                const Cell beside{x + step.x, y + step.y};
                if (!cut.regions.contains(beside)) continue;
                const std::uint32_t region = cut.regions.at(beside);
                if (region == 0 || region == kNotCut) continue;
                cut.regions.at({x, y}) = region;
                is_any = true;
                break;
            }
        }
    }
}

}  // namespace quadcut
