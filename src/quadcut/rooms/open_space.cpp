// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/open_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

constexpr int kNumDirections = 36;
/// Cells of an obstacle are tried about so far apart, and at most so many.
constexpr double kBetweenTriedM = 0.1;
constexpr std::size_t kMaxTried = 12;
constexpr std::size_t kObstaclesPerChunk = 4;
/// Doors beside a pier are at most this wide.
constexpr double kMaxGapM = 1.6;
/// A flaw of the map leaves a gap of at most this; to one side is enough.
constexpr double kFlawM = 0.1;
/// A wall has at least this length in line with a pier, and a face within this of its middle.
constexpr double kMinWallM = 0.4;
constexpr double kMinPieceM = 0.2;
constexpr double kFaceM = 0.25;

/// Questions about free space; positions and lengths in cells.
class WallSeeker {
public:
    WallSeeker(const Raster<std::uint8_t>& free, double resolution_m)
        : free_(free),
          resolution_m_(resolution_m),
          flaw_(kFlawM / resolution_m),
          max_gap_(kMaxGapM / resolution_m),
          min_wall_(kMinWallM / resolution_m),
          face_(kFaceM / resolution_m) {
        for (int k = 0; k < kNumDirections; ++k) {
            const double angle = std::numbers::pi * k / kNumDirections;
            const Point along{std::cos(angle), std::sin(angle)};
            directions_.emplace_back(way_along(along), way_along({-along.x, -along.y}));
        }
    }

    /// Whether an obstacle is a part of a wall with a gap on both sides of it, as the pier between
    /// two doors and what a flaw of the map has cut off: in some direction through it
    /// there is a wall end on both sides.
    [[nodiscard]] bool is_pier(const std::vector<std::size_t>& obstacle) const {
        // The leaf of an open door may stand out of a pier: cells all over it are tried.
        Box box;
        for (const std::size_t offset : obstacle)
            box.include({free_.cell(offset), free_.cell(offset)});
        const double extent = std::hypot(box.width() - 1, box.height() - 1);
        const std::size_t num_tried = std::min(
            kMaxTried, 1 + static_cast<std::size_t>(extent / (kBetweenTriedM / resolution_m_)));
        const std::size_t stride = std::max<std::size_t>(1, obstacle.size() / num_tried);
        for (std::size_t i = stride / 2; i < obstacle.size(); i += stride) {
            const Cell cell = free_.cell(obstacle[i]);
            for (const auto& [forward, back] : directions_) {
                const double ahead = gap_to_wall(cell, forward, max_gap_);
                const double behind = gap_to_wall(cell, back, std::isinf(ahead) ? flaw_ : max_gap_);
                if (std::max(ahead, behind) <= max_gap_) return true;
                if (std::min(ahead, behind) <= flaw_ && is_piece_of_wall(cell, forward.along)) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    /// In one direction out of the middle of a cell: the cells a step apart. From every cell the
    /// same ones, also where a step ends between two.
    struct Way {
        Point along;
        std::vector<Cell> steps;
    };

    /// As far as any question goes: through an obstacle, over a gap and along a wall.
    [[nodiscard]] Way way_along(const Point& along) const {
        Way way{along, {}};
        way.steps.reserve(static_cast<std::size_t>(2.0 * max_gap_ + min_wall_) + 4);
        for (double t = 0.0; t < 2.0 * max_gap_ + min_wall_ + 3.0; t += 1.0) {
            way.steps.push_back(cell_of({0.5 + t * along.x, 0.5 + t * along.y}));
        }
        return way;
    }
    [[nodiscard]] bool is_free(Cell cell) const {
        return free_.contains(cell) && free_.at(cell) != 0;
    }
    /// At a point seen from the lower left corner of a cell.
    [[nodiscard]] bool is_free_at(Cell from, const Point& at) const {
        const Cell cell = cell_of(at);
        return is_free({from.x + cell.x, from.y + cell.y});
    }
    [[nodiscard]] bool has_face(Cell from, const Point& at, const Point& side) const {
        for (double t = 1.0; t <= face_; t += 1.0) {
            if (is_free_at(from, {at.x + t * side.x, at.y + t * side.y})) return true;
        }
        return false;
    }
    /// Whether the obstacle is long along a line through it, and thin everywhere on it.
    [[nodiscard]] bool is_piece_of_wall(Cell cell, const Point& along) const {
        double length = -1.0;
        for (const double sign : {1.0, -1.0}) {
            for (double t = 0.0; t <= max_gap_; t += 1.0, length += 1.0) {
                const Point at{0.5 + sign * t * along.x, 0.5 + sign * t * along.y};
                if (is_free_at(cell, at)) break;
                if (!has_face(cell, at, {-along.y, along.x}) ||
                    !has_face(cell, at, {along.y, -along.x})) {
                    return false;
                }
            }
        }
        return length >= kMinPieceM / resolution_m_;
    }
    /// Out of the obstacle, over a gap, and into a thin wall that goes on in this direction: the
    /// length of the gap; infinite when there is no such wall within `max_gap`.
    [[nodiscard]] double gap_to_wall(Cell from, const Way& way, double max_gap) const {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        const Cell* step = way.steps.data();
        const auto is_free_here = [&] { return is_free({from.x + step->x, from.y + step->y}); };
        const auto steps_since = [&](const Cell* start) {
            return static_cast<double>(step - start);
        };
        for (; !is_free_here(); ++step) {
            if (steps_since(way.steps.data()) > max_gap_) return kNone;
        }
        const Cell* const edge = step;
        for (; is_free_here(); ++step) {
            if (steps_since(edge) > max_gap) return kNone;
        }
        const double gap = steps_since(edge);
        const Point& along = way.along;
        for (const Cell* const wall = step; steps_since(wall) < min_wall_; ++step) {
            const double t = steps_since(way.steps.data());
            const Point at{0.5 + t * along.x, 0.5 + t * along.y};
            if (is_free_here() || !has_face(from, at, {-along.y, along.x}) ||
                !has_face(from, at, {along.y, -along.x})) {
                return kNone;
            }
        }
        return gap;
    }

    const Raster<std::uint8_t>& free_;
    /// There and back.
    std::vector<std::pair<Way, Way>> directions_;
    double resolution_m_;
    double flaw_;
    double max_gap_;
    double min_wall_;
    double face_;
};

using Obstacles = std::vector<std::vector<std::size_t>>;

/// What is connected, does not leave the raster, and has fewer cells than `max_cells`.
Obstacles small_obstacles(const Raster<std::uint8_t>& free, double max_cells,
                          const Executor& executor) {
    const ConnectedParts parts = connected_parts(
        free, [&](std::size_t i) { return free.values[i] == 0 ? 1U : 0U; }, Connectivity::eight,
        executor);
    std::vector<bool> is_small = parts.islands(max_cells);
    // Cells from the first one outward: of these some are tried as parts of a wall.
    Obstacles small;
    std::vector<bool> seen(free.values.size(), false);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        if (!is_small[run.part]) return;
        is_small[run.part] = false;
        small.push_back(flood(free, first, seen, Connectivity::eight,
                              [&](std::size_t cell) { return free.values[cell] == 0; }));
    });
    return small;
}

bool is_mostly_in_line(const std::vector<std::size_t>& obstacle, const Raster<std::uint8_t>& free,
                       const WallLines& lines) {
    const auto num_in_line = std::count_if(obstacle.begin(), obstacle.end(), [&](std::size_t i) {
        const Cell cell = free.cell(i);
        return lines.is_wall({cell.x - free.origin.x + 0.5, cell.y - free.origin.y + 0.5});
    });
    return 2 * static_cast<std::size_t>(num_in_line) >= obstacle.size();
}

}  // namespace

Raster<std::uint8_t> open_space(Raster<std::uint8_t> kept, double resolution_m,
                                double max_furniture_m2, const WallLines& lines,
                                const Executor& executor) {
    const Obstacles small =
        small_obstacles(kept, max_furniture_m2 / (resolution_m * resolution_m), executor);
    std::vector<std::uint8_t> is_wall(small.size(), 0);
    if (!small.empty()) {
        const WallSeeker walls(kept, resolution_m);
        parallel_for(executor, small.size(), kObstaclesPerChunk,
                     [&](std::size_t first, std::size_t last) {
                         for (std::size_t i = first; i < last; ++i) {
                             const bool is_in_line = is_mostly_in_line(small[i], kept, lines);
                             is_wall[i] = is_in_line || walls.is_pier(small[i]) ? 1 : 0;
                         }
                     });
    }
    Raster<std::uint8_t> open = std::move(kept);
    for (std::size_t i = 0; i < small.size(); ++i) {
        if (is_wall[i] != 0) continue;
        for (const std::size_t cell : small[i]) open.values[cell] = 1;
    }
    return open;
}

}  // namespace quadcut
