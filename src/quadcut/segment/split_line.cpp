// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/split_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "quadcut/map/flood.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

/// So far from a wall a point may be.
constexpr double kSnapM = 1.0;
/// The line goes on into the wall, which may move a little.
constexpr double kIntoWallM = 0.2;
/// What is smaller and shut off is taken for the inside of furniture.
constexpr double kMinPartM2 = 4.0;
constexpr double kSearchM = 3.0;
constexpr double kStepM = 0.25;
constexpr int kNumDirections = 12;
/// So that the answer takes seconds at most.
constexpr std::size_t kMaxCellsToSearch = 400000000;

bool is_in(const Raster<std::uint8_t>& room, const Point& point) {
    const Cell cell = cell_of(point);
    return room.contains(cell) && room.at(cell) != 0;
}

/// How far one can go from a point of the room in a direction, cells.
double free_length(const Raster<std::uint8_t>& room, const Point& from, const Point& direction) {
    constexpr double kStep = 0.25;
    double length = 0.0;
    while (is_in(room, along(from, direction, length + kStep))) length += kStep;
    return length;
}

std::string metres(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f m", value);
    return text.data();
}

/// The parts of the room that the line leaves, seen from its two sides, the smaller first; one
/// when they are the same.
std::vector<std::vector<std::size_t>> parts_beside(const Raster<std::uint8_t>& room,
                                                   const SplitLine& line) {
    std::vector<bool> is_wall(room.values.size(), false);
    std::vector<std::size_t> on_line;
    for (const Cell cell : cells_of(line)) {
        if (!room.contains(cell)) continue;
        is_wall[room.offset(cell)] = true;
        if (room.at(cell) != 0) on_line.push_back(room.offset(cell));
    }
    std::vector<bool> seen(room.values.size(), false);
    std::vector<std::vector<std::size_t>> parts;
    for (const std::size_t cell : on_line) {
        for (const std::size_t next : Neighbours(room, cell, Connectivity::four)) {
            if (seen[next] || is_wall[next] || room.values[next] == 0) continue;
            parts.push_back(flood(room, next, seen, Connectivity::four, [&](std::size_t i) {
                return room.values[i] != 0 && !is_wall[i];
            }));
        }
    }
    std::sort(parts.begin(), parts.end(),
              [](const auto& p, const auto& q) { return p.size() < q.size(); });
    return parts;
}

/// The line through two points of the room, from wall to wall.
SplitLine drawn_to_walls(const Raster<std::uint8_t>& room, const Point& middle,
                         const Point& direction, double into_wall) {
    const Point back{-direction.x, -direction.y};
    const Point end = along(middle, direction, free_length(room, middle, direction) + into_wall);
    const Point begin = along(middle, back, free_length(room, middle, back) + into_wall);
    return {cell_of(begin), cell_of(end)};
}

/// Why a line that reaches the walls is no cut; fills `part` when it is one.
std::string check(const Raster<std::uint8_t>& room, const SplitLine& line, double resolution_m,
                  std::vector<Cell>& part) {
    const double cell_m2 = resolution_m * resolution_m;
    std::vector<std::vector<std::size_t>> parts = parts_beside(room, line);
    // Slivers beside the line are no parts.
    std::erase_if(parts, [&](const auto& cells) {
        return parts.size() > 2 && static_cast<double>(cells.size()) * cell_m2 < 0.1;
    });
    if (parts.size() < 2) return "the room goes on around the line's ends";
    if (parts.size() > 2) return "the line cuts the room into more than two parts";
    const double area_m2 = static_cast<double>(parts.front().size()) * cell_m2;
    if (area_m2 < kMinPartM2) {
        return "the smaller part would have " + metres(area_m2) + "^2: expected " +
               metres(kMinPartM2) + "^2 at least";
    }
    for (const std::size_t i : parts.front()) part.push_back(room.cell(i));
    return {};
}

}  // namespace

std::vector<Cell> cells_of(const SplitLine& line) {
    std::vector<Cell> cells;
    walk_line({line.from.x + 0.5, line.from.y + 0.5}, {line.to.x + 0.5, line.to.y + 0.5},
              [&](Cell cell, double) {
                  cells.push_back(cell);
                  return true;
              });
    return cells;
}

SplitPlan plan_split(const Raster<std::uint8_t>& room, const Point& from, const Point& to,
                     double resolution_m) {
    SplitPlan plan;
    const double length = distance(from, to);
    if (length * resolution_m < 0.1) {
        plan.reason = "the two points are the same";
        return plan;
    }
    const Point middle{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0};
    const Point direction{(to.x - from.x) / length, (to.y - from.y) / length};
    const Point back{-direction.x, -direction.y};
    if (!is_in(room, middle)) {
        plan.reason = "the middle of the line is not in the room";
        return plan;
    }
    for (const Point& way : {direction, back}) {
        const double beyond = free_length(room, middle, way) - length / 2.0;
        if (beyond * resolution_m < -kSnapM) {
            plan.reason = "a wall stands between the two points";
            return plan;
        }
        if (beyond * resolution_m <= kSnapM) continue;
        plan.reason = "the line ends " + metres(beyond * resolution_m) +
                      " before a wall: " + metres(kSnapM) + " at most are drawn on";
        return plan;
    }
    const SplitLine line = drawn_to_walls(room, middle, direction, kIntoWallM / resolution_m);
    plan.reason = check(room, line, resolution_m, plan.part);
    if (plan.reason.empty()) plan.line = line;
    return plan;
}

std::optional<SplitLine> nearest_split(const Raster<std::uint8_t>& room, const Point& from,
                                       const Point& to, double resolution_m) {
    const Point middle{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0};
    const double yaw_rad = std::atan2(to.y - from.y, to.x - from.x);
    // A place farther off, or a line turned, is the farther; a turn of 90 degrees as 2 m.
    std::vector<std::pair<double, std::pair<Point, double>>> places;
    const int reach = static_cast<int>(kSearchM / kStepM);
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            for (int k = 0; k < kNumDirections; ++k) {
                const double turn = std::numbers::pi * k / kNumDirections;
                const double off_rad = std::min(turn, std::numbers::pi - turn);
                const Point place{middle.x + x * kStepM / resolution_m,
                                  middle.y + y * kStepM / resolution_m};
                if (!is_in(room, place)) continue;
                const double far_m = kStepM * std::hypot(x, y) + 4.0 * off_rad / std::numbers::pi;
                places.push_back({far_m, {place, yaw_rad + turn}});
            }
        }
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& p, const auto& q) { return p.first < q.first; });
    places.resize(std::min(places.size(), kMaxCellsToSearch / (room.values.size() + 1) + 50));
    for (const auto& [far, place] : places) {
        const Point direction{std::cos(place.second), std::sin(place.second)};
        const SplitLine line =
            drawn_to_walls(room, place.first, direction, kIntoWallM / resolution_m);
        std::vector<Cell> part;
        if (check(room, line, resolution_m, part).empty()) {
            return drawn_to_walls(room, place.first, direction, 0.0);
        }
    }
    return std::nullopt;
}

}  // namespace quadcut
