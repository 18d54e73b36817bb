// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/split_line.hpp"

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
constexpr double kMinLineM = 0.1;
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

Point middle_of(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

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

/// The parts of a line that lie in the room: all of it from the first to the last, walls between
/// included, then each alone, the longest first.
std::vector<std::pair<Point, Point>> runs_of(const Raster<std::uint8_t>& room, const Point& from,
                                             const Point& to) {
    std::vector<std::pair<double, double>> runs;
    bool is_inside = false;
    walk_line(from, to, [&](Cell cell, double t) {
        const bool is_now = room.contains(cell) && room.at(cell) != 0;
        if (is_now && !is_inside) runs.emplace_back(t, 1.0);
        if (!is_now && is_inside) runs.back().second = t;
        is_inside = is_now;
        return true;
    });
    if (runs.size() > 1) runs.emplace_back(runs.front().first, runs.back().second);
    std::stable_sort(runs.begin(), runs.end(), [](const auto& p, const auto& q) {
        return p.second - p.first > q.second - q.first;
    });
    std::vector<std::pair<Point, Point>> points;
    const Point way{to.x - from.x, to.y - from.y};
    for (const auto& [begin, end] : runs) {
        points.emplace_back(along(from, way, begin), along(from, way, end));
    }
    return points;
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
    walk_line(middle_of(line.from), middle_of(line.to), [&](Cell cell, double) {
        cells.push_back(cell);
        return true;
    });
    return cells;
}

SplitPlan plan_split(const Raster<std::uint8_t>& room, const Point& from, const Point& to,
                     double resolution_m) {
    SplitPlan plan;
    const double length = distance(from, to);
    if (length * resolution_m < kMinLineM) {
        plan.reason = "less than " + metres(kMinLineM) + " of the line are in the room";
        return plan;
    }
    const Point direction{(to.x - from.x) / length, (to.y - from.y) / length};
    const Point back{-direction.x, -direction.y};
    for (const auto& [begin, end] : runs_of(room, from, to)) {
        std::string reason;
        const double before = free_length(room, begin, back);
        const double behind = free_length(room, end, direction);
        const double beyond_m = std::max(before, behind) * resolution_m;
        const double into_wall = kIntoWallM / resolution_m;
        const SplitLine line{cell_of(along(begin, back, before + into_wall)),
                             cell_of(along(end, direction, behind + into_wall))};
        if (beyond_m > kSnapM) {
            reason = "the line ends " + metres(beyond_m) + " before a wall: " + metres(kSnapM) +
                     " at most are drawn on";
        } else {
            reason = check(room, line, resolution_m, plan.part);
        }
        if (reason.empty()) return {line, std::move(plan.part), {}};
        // What is wrong with the whole line comes first.
        if (plan.reason.empty()) plan.reason = reason;
    }
    if (plan.reason.empty()) plan.reason = "the line is not in the room";
    return plan;
}

std::optional<SplitLine> nearest_split(const Raster<std::uint8_t>& room, const Point& from,
                                       const Point& to, double resolution_m) {
    const Point middle{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0};
    const double yaw_rad = std::atan2(to.y - from.y, to.x - from.x);
    struct Place {
        double far_m = 0.0;
        Point inside;
        double yaw_rad = 0.0;
    };
    // A place farther off, or a line turned, is the farther; a turn of 90 degrees as 2 m.
    std::vector<Place> places;
    const int reach = static_cast<int>(kSearchM / kStepM);
    for_each_cell({{-reach, -reach}, {reach, reach}}, [&](Cell step) {
        const Point place{middle.x + step.x * kStepM / resolution_m,
                          middle.y + step.y * kStepM / resolution_m};
        for (int k = 0; k < kNumDirections && is_in(room, place); ++k) {
            const double turn = std::numbers::pi * k / kNumDirections;
            const double off_rad = std::min(turn, std::numbers::pi - turn);
            places.push_back(
                {kStepM * std::hypot(step.x, step.y) + 4.0 * off_rad / std::numbers::pi, place,
                 yaw_rad + turn});
        }
    });
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& p, const Place& q) { return p.far_m < q.far_m; });
    places.resize(std::min(places.size(), kMaxCellsToSearch / (room.values.size() + 1) + 50));
    for (const Place& place : places) {
        const auto at_wall = [&](double sign) {
            const Point way{sign * std::cos(place.yaw_rad), sign * std::sin(place.yaw_rad)};
            return cell_of(along(place.inside, way, free_length(room, place.inside, way)));
        };
        const SplitLine line{at_wall(-1.0), at_wall(1.0)};
        // As it will be drawn by whoever takes it.
        if (plan_split(room, middle_of(line.from), middle_of(line.to), resolution_m).line) {
            return line;
        }
    }
    return std::nullopt;
}

}  // namespace quadcut
