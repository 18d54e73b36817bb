// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/opening.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

constexpr double kJambWithinWidths = 1.6;
constexpr double kWallM = 0.6;
constexpr double kFaceWithinM = 0.4;
constexpr double kLineM = 6.0;
constexpr double kProfileFromM = 0.15;
constexpr double kProfileStepM = 0.1;
constexpr int kProfileSteps = 9;
constexpr double kMaxWideningM = 1.5;

/// Questions about obstacles; positions and lengths in cells.
struct Surroundings {
    const Raster<float>& clearance;
    double resolution_m;

    [[nodiscard]] bool is_open(Cell cell) const {
        return clearance.contains(cell) && clearance.at(cell) > 0.0F;
    }
    [[nodiscard]] bool is_open(const Point& at) const { return is_open(cell_of(at)); }
    /// From a point on, whatever the direction, all is open for so many cells, and one beside it.
    [[nodiscard]] double open_cells_from(const Point& at) const {
        const Cell cell = cell_of(at);
        if (!clearance.contains(cell)) return 0.0;
        // Both points may lie half a diagonal away from the middles of their cells.
        constexpr double kBesideAndDiagonal = 2.0;
        return std::floor(static_cast<double>(clearance.at(cell)) / resolution_m -
                          kBesideAndDiagonal);
    }
    /// Whether there is free space within 0.4 m of a point, to that side.
    [[nodiscard]] bool is_open_beside(const Point& at, const Direction& side) const {
        for (double t = 1.0; t <= kFaceWithinM / resolution_m; t += 1.0) {
            if (is_open(Point{at.x + t * side.x, at.y + t * side.y})) return true;
        }
        return false;
    }
};

/// The obstacle cell nearest to the saddle, and the nearest one on the other side of it: more than
/// 120 degrees away from the first, within 1.6 half-widths.
void find_jambs(const Surroundings& around, const Saddle& saddle, Opening& out) {
    const double free_cells = static_cast<double>(saddle.clearance_m) / around.resolution_m;
    const double limit = kJambWithinWidths * (free_cells + 0.5) + 1.0;
    const auto radius = static_cast<std::int32_t>(std::ceil(limit));
    const auto max_squared = static_cast<std::int32_t>(limit * limit);
    // The clearance says that there is none nearer.
    const auto min_squared = static_cast<std::int32_t>(free_cells * free_cells);
    const auto find_nearest = [&](const auto& counts) {
        std::int32_t nearest = max_squared + 1;
        Cell best{};
        for (std::int32_t dy = -radius; dy <= radius; ++dy) {
            const auto look = [&](std::int32_t dx) {
                const std::int32_t squared = dx * dx + dy * dy;
                if (squared < min_squared || squared >= nearest || !counts(dx, dy, squared) ||
                    around.is_open(Cell{saddle.a.x + dx, saddle.a.y + dy})) {
                    return;
                }
                nearest = squared;
                best = {dx, dy};
            };
            // What is nearer than the nearest one so far, and not too near to be one.
            const auto reach = [&](std::int32_t squared) {
                const std::int32_t left = squared - dy * dy;
                return left < 0 ? -1 : static_cast<std::int32_t>(std::sqrt(left));
            };
            const std::int32_t far = std::min(radius, reach(nearest));
            const std::int32_t near = std::max(0, reach(min_squared));
            for (std::int32_t dx = -far; dx <= -near; ++dx) look(dx);
            for (std::int32_t dx = std::max(near, 1 - near); dx <= far; ++dx) look(dx);
        }
        return std::pair{best, nearest};
    };
    const auto [first, distance] = find_nearest([](auto...) { return true; });
    if (distance > max_squared) return;
    const auto [second, other_distance] =
        find_nearest([first = first, distance = distance](int dx, int dy, int squared) {
            const double dot = dx * first.x + dy * first.y;
            return dot < 0.0 && 4.0 * dot * dot >= static_cast<double>(squared) * distance;
        });
    if (other_distance > max_squared) return;
    out.jambs = {Cell{saddle.a.x + first.x, saddle.a.y + first.y},
                 Cell{saddle.a.x + second.x, saddle.a.y + second.y}};
    out.has_jambs = true;
}

/// Walks from a jamb away from the opening, in line with it, and notes how much of the way is wall
/// with free space near on its left, its right, and both.
struct WallRun {
    double left_m = 0.0;
    double right_m = 0.0;
    double both_m = 0.0;
};

WallRun walk_along_wall(const Surroundings& around, Cell jamb, const Direction& along) {
    WallRun run;
    const Direction left{-along.y, along.x};
    const Direction right{along.y, -along.x};
    for (double t = 0.0; t <= kWallM / around.resolution_m; t += 1.0) {
        const Point at{jamb.x + 0.5 + t * along.x, jamb.y + 0.5 + t * along.y};
        if (around.is_open(at)) break;
        const bool on_left = around.is_open_beside(at, left);
        const bool on_right = around.is_open_beside(at, right);
        if (on_left) run.left_m += around.resolution_m;
        if (on_right) run.right_m += around.resolution_m;
        if (on_left && on_right) run.both_m += around.resolution_m;
    }
    return run;
}

/// The surfaces of walls in line with an opening, wherever they are behind a jamb: rows of columns
/// and of partitions are what an opening is part of. A wall may be a cell off the line.
double wall_in_line_m(const Surroundings& around, Cell jamb, const Direction& along) {
    double length_m = 0.0;
    const Direction left{-along.y, along.x};
    const Direction right{along.y, -along.x};
    for (double t = 0.0; t <= kLineM / around.resolution_m; t += 1.0) {
        const double num_open =
            around.open_cells_from({jamb.x + 0.5 + t * along.x, jamb.y + 0.5 + t * along.y});
        if (num_open >= 1.0) {
            t += num_open;
            continue;
        }
        for (const double off : {0.0, -1.0, 1.0}) {
            const Point at{jamb.x + 0.5 + t * along.x + off * left.x,
                           jamb.y + 0.5 + t * along.y + off * left.y};
            if (around.is_open(at)) continue;
            if (!around.is_open_beside(at, left) && !around.is_open_beside(at, right)) continue;
            length_m += around.resolution_m;
            break;
        }
    }
    return length_m;
}

std::array<double, 2> sorted(double p, double q) { return {std::min(p, q), std::max(p, q)}; }

/// The mean reach of free space beyond a jamb, `outward` along the opening, over lines parallel to
/// it on the side to which `aside` points. The lines begin inside the opening's width.
double widening_beyond(const Surroundings& around, Cell jamb, const Direction& outward,
                       const Direction& aside, double width_cells) {
    const double inside = std::min(0.3 / around.resolution_m, 0.4 * width_cells);
    const double limit = kMaxWideningM / around.resolution_m;
    double sum = 0.0;
    for (int step = 0; step < kProfileSteps; ++step) {
        const double t = (kProfileFromM + kProfileStepM * step) / around.resolution_m;
        Point at{jamb.x + 0.5 + aside.x * t - outward.x * inside,
                 jamb.y + 0.5 + aside.y * t - outward.y * inside};
        double beyond = -inside;
        while (beyond < limit && around.is_open(at)) {
            at = {at.x + outward.x, at.y + outward.y};
            beyond += 1.0;
        }
        sum += std::clamp(beyond, 0.0, limit) * around.resolution_m;
    }
    return sum / kProfileSteps;
}

}  // namespace

Opening measure_opening(const Raster<float>& clearance_m, double resolution_m,
                        const Saddle& saddle) {
    Opening out;
    const Surroundings around{clearance_m, resolution_m};
    // The border runs across the step from a to b.
    out.along = {std::abs(static_cast<double>(saddle.b.y - saddle.a.y)),
                 std::abs(static_cast<double>(saddle.b.x - saddle.a.x))};
    find_jambs(around, saddle, out);
    const double chord_x = out.jambs[1].x - out.jambs[0].x;
    const double chord_y = out.jambs[1].y - out.jambs[0].y;
    const double width_cells = std::hypot(chord_x, chord_y);
    if (!out.has_jambs || width_cells == 0.0) return out;
    out.width_m = width_cells * resolution_m;
    out.along = {chord_x / width_cells, chord_y / width_cells};
    const Direction back{-out.along.x, -out.along.y};
    const WallRun end = walk_along_wall(around, out.jambs[1], out.along);
    // Seen from the other end, left and right change places.
    const WallRun start = walk_along_wall(around, out.jambs[0], back);
    out.thin_wall_m = sorted(start.both_m, end.both_m);
    out.flush_wall_m =
        sorted(std::min(end.left_m, start.right_m), std::min(end.right_m, start.left_m));
    out.line_of_walls_m = sorted(wall_in_line_m(around, out.jambs[0], back),
                                 wall_in_line_m(around, out.jambs[1], out.along));
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        const Direction aside{-sign * out.along.y, sign * out.along.x};
        out.widening_m[side] =
            sorted(widening_beyond(around, out.jambs[0], back, aside, width_cells),
                   widening_beyond(around, out.jambs[1], out.along, aside, width_cells));
    }
    if (out.widening_m[0][0] < out.widening_m[1][0]) {
        std::swap(out.widening_m[0], out.widening_m[1]);
    }
    return out;
}

}  // namespace quadcut
