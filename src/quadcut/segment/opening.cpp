// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/opening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadcut {
namespace {

constexpr double kJambWithinWidths = 1.6;
constexpr double kWallM = 0.6;
constexpr double kFaceWithinM = 0.4;
constexpr double kProfileFromM = 0.15;
constexpr double kProfileStepM = 0.1;
constexpr int kProfileSteps = 9;
constexpr double kMaxWideningM = 1.5;

struct Vector {
    double x = 0.0;
    double y = 0.0;
};

/// Questions about obstacles; positions and lengths in cells.
struct Surroundings {
    const Raster<float>& clearance;
    double resolution_m;

    [[nodiscard]] bool is_open(Cell cell) const {
        return clearance.contains(cell) && clearance.at(cell) > 0.0F;
    }
    [[nodiscard]] bool is_open(const Vector& at) const {
        return is_open(Cell{static_cast<std::int32_t>(std::floor(at.x)),
                            static_cast<std::int32_t>(std::floor(at.y))});
    }
};

/// The obstacle cell nearest to the saddle, and the nearest one on the other side of it: more than
/// 120 degrees away from the first, within 1.6 half-widths.
void find_jambs(const Surroundings& around, const Saddle& saddle, Opening& out) {
    const double limit =
        kJambWithinWidths * (static_cast<double>(saddle.clearance_m) / around.resolution_m + 0.5) +
        1.0;
    const auto radius = static_cast<std::int32_t>(std::ceil(limit));
    const auto find_nearest = [&](const auto& counts) {
        double nearest = std::numeric_limits<double>::infinity();
        Cell best{};
        for (std::int32_t dy = -radius; dy <= radius; ++dy) {
            for (std::int32_t dx = -radius; dx <= radius; ++dx) {
                const double length = std::hypot(dx, dy);
                const Cell cell{saddle.a.x + dx, saddle.a.y + dy};
                if (length > limit || length >= nearest || around.is_open(cell)) continue;
                if (!counts(dx, dy, length)) continue;
                nearest = length;
                best = {dx, dy};
            }
        }
        return std::pair{best, nearest};
    };
    const auto [first, distance] = find_nearest([](auto...) { return true; });
    if (!std::isfinite(distance)) return;
    const auto [second, other_distance] =
        find_nearest([first = first, distance = distance](int dx, int dy, double length) {
            return dx * first.x + dy * first.y <= -0.5 * std::max(1e-9, length * distance);
        });
    if (!std::isfinite(other_distance)) return;
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

WallRun walk_along_wall(const Surroundings& around, Cell jamb, const Vector& along) {
    WallRun run;
    const Vector left{-along.y, along.x};
    const auto is_free_beside = [&](const Vector& at, double sign) {
        for (double t = 1.0; t <= kFaceWithinM / around.resolution_m; t += 1.0) {
            if (around.is_open(Vector{at.x + sign * t * left.x, at.y + sign * t * left.y})) {
                return true;
            }
        }
        return false;
    };
    for (double t = 0.0; t <= kWallM / around.resolution_m; t += 1.0) {
        const Vector at{jamb.x + 0.5 + t * along.x, jamb.y + 0.5 + t * along.y};
        if (around.is_open(at)) break;
        const bool on_left = is_free_beside(at, 1.0);
        const bool on_right = is_free_beside(at, -1.0);
        if (on_left) run.left_m += around.resolution_m;
        if (on_right) run.right_m += around.resolution_m;
        if (on_left && on_right) run.both_m += around.resolution_m;
    }
    return run;
}

/// The mean reach of free space beyond a jamb, `outward` along the opening, over lines parallel to
/// it on the side to which `aside` points. The lines begin inside the opening's width.
double widening_beyond(const Surroundings& around, Cell jamb, const Vector& outward,
                       const Vector& aside, double width_cells) {
    const double inside = std::min(0.3 / around.resolution_m, 0.4 * width_cells);
    const double limit = kMaxWideningM / around.resolution_m;
    double sum = 0.0;
    for (int step = 0; step < kProfileSteps; ++step) {
        const double t = (kProfileFromM + kProfileStepM * step) / around.resolution_m;
        Vector at{jamb.x + 0.5 + aside.x * t - outward.x * inside,
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
    find_jambs(around, saddle, out);
    const Vector chord{static_cast<double>(out.jambs[1].x - out.jambs[0].x),
                       static_cast<double>(out.jambs[1].y - out.jambs[0].y)};
    const double width_cells = std::hypot(chord.x, chord.y);
    if (!out.has_jambs || width_cells == 0.0) return out;
    out.width_m = width_cells * resolution_m;
    const Vector along{chord.x / width_cells, chord.y / width_cells};
    const Vector back{-along.x, -along.y};
    const WallRun end = walk_along_wall(around, out.jambs[1], along);
    // Seen from the other end, left and right change places.
    const WallRun start = walk_along_wall(around, out.jambs[0], back);
    out.thin_wall_m = {std::min(start.both_m, end.both_m), std::max(start.both_m, end.both_m)};
    out.flush_wall_m = {std::min(end.left_m, start.right_m), std::min(end.right_m, start.left_m)};
    std::sort(out.flush_wall_m.begin(), out.flush_wall_m.end());
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        const Vector aside{-sign * along.y, sign * along.x};
        auto& widening = out.widening_m[side];
        widening = {widening_beyond(around, out.jambs[0], back, aside, width_cells),
                    widening_beyond(around, out.jambs[1], along, aside, width_cells)};
        std::sort(widening.begin(), widening.end());
    }
    if (out.widening_m[0][0] < out.widening_m[1][0])
        std::swap(out.widening_m[0], out.widening_m[1]);
    return out;
}

}  // namespace quadcut
