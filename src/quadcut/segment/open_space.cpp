// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/open_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/flood.hpp"

namespace quadcut {
namespace {

constexpr int kNumDirections = 36;
constexpr std::size_t kNumTried = 12;
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
          flaw_(kFlawM / resolution_m),
          max_gap_(kMaxGapM / resolution_m),
          min_wall_(kMinWallM / resolution_m),
          min_piece_(kMinPieceM / resolution_m),
          face_(kFaceM / resolution_m) {}

    /// Whether an obstacle is a part of a wall with a gap on both sides of it, as the pier between
    /// two doors and what a flaw of the map has cut off: in some direction through it
    /// there is a wall end on both sides.
    [[nodiscard]] bool is_pier(const std::vector<std::size_t>& obstacle) const {
        // The leaf of an open door may stand out of a pier: some of its cells are tried.
        const std::size_t stride = std::max<std::size_t>(1, obstacle.size() / kNumTried);
        for (std::size_t i = stride / 2; i < obstacle.size(); i += stride) {
            const Cell cell = free_.cell(obstacle[i]);
            const Point middle{cell.x + 0.5, cell.y + 0.5};
            for (int k = 0; k < kNumDirections; ++k) {
                const double angle = std::numbers::pi * k / kNumDirections;
                const Point along{std::cos(angle), std::sin(angle)};
                const double ahead = gap_to_wall(middle, along);
                const double behind = gap_to_wall(middle, {-along.x, -along.y});
                if (std::max(ahead, behind) <= max_gap_) return true;
                if (std::min(ahead, behind) <= flaw_ && is_piece_of_wall(middle, along)) return true;
            }
        }
        return false;
    }

private:
    [[nodiscard]] bool is_free(const Point& at) const {
        const Cell cell{static_cast<std::int32_t>(std::floor(at.x)),
                        static_cast<std::int32_t>(std::floor(at.y))};
        return free_.contains(cell) && free_.at(cell) != 0;
    }
    [[nodiscard]] bool has_face(const Point& at, const Point& side) const {
        for (double t = 1.0; t <= face_; t += 1.0) {
            if (is_free({at.x + t * side.x, at.y + t * side.y})) return true;
        }
        return false;
    }
    /// Whether the obstacle is long along a line through it, and thin everywhere on it.
    [[nodiscard]] bool is_piece_of_wall(const Point& middle, const Point& along) const {
        double length = -1.0;
        for (const double sign : {1.0, -1.0}) {
            for (double t = 0.0; t <= max_gap_; t += 1.0, length += 1.0) {
                const Point at{middle.x + sign * t * along.x, middle.y + sign * t * along.y};
                if (is_free(at)) break;
                if (!has_face(at, {-along.y, along.x}) || !has_face(at, {along.y, -along.x})) {
                    return false;
                }
            }
        }
        return length >= min_piece_;
    }
    /// Out of the obstacle, over a gap, and into a thin wall that goes on in this direction: the
    /// length of the gap; infinite when there is no such wall.
    [[nodiscard]] double gap_to_wall(const Point& from, const Point& along) const {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        const auto at = [&](double t) { return Point{from.x + t * along.x, from.y + t * along.y}; };
        double t = 0.0;
        while (!is_free(at(t))) {
            if (t > max_gap_) return kNone;
            t += 1.0;
        }
        const double edge = t;
        while (is_free(at(t))) {
            if (t - edge > max_gap_) return kNone;
            t += 1.0;
        }
        const double gap = t - edge;
        for (const double end = t + min_wall_; t < end; t += 1.0) {
            if (is_free(at(t)) || !has_face(at(t), {-along.y, along.x}) ||
                !has_face(at(t), {along.y, -along.x})) {
                return kNone;
            }
        }
        return gap;
    }

    const Raster<std::uint8_t>& free_;
    double flaw_;
    double max_gap_;
    double min_wall_;
    double min_piece_;
    double face_;
};

}  // namespace

Raster<std::uint8_t> open_space(const Raster<std::uint8_t>& kept, double resolution_m,
                                const OpenSpaceOptions& options) {
    Raster<std::uint8_t> open = kept;
    const WallSeeker walls(kept, resolution_m);
    const double max_cells = options.max_furniture_m2 / (resolution_m * resolution_m);
    std::vector<bool> seen(kept.values.size(), false);
    for (std::size_t seed = 0; seed < kept.values.size(); ++seed) {
        if (kept.values[seed] != 0 || seen[seed]) continue;
        const std::vector<std::size_t> obstacle =
            flood(kept, seed, seen, Connectivity::eight,
                  [&](std::size_t cell) { return kept.values[cell] == 0; });
        const bool is_furniture =
            static_cast<double>(obstacle.size()) < max_cells &&
            std::none_of(obstacle.begin(), obstacle.end(),
                         [&](std::size_t cell) { return is_on_edge(kept, cell); }) &&
            !walls.is_pier(obstacle);
        if (!is_furniture) continue;
        for (const std::size_t cell : obstacle) open.values[cell] = 1;
    }
    return open;
}

}  // namespace quadcut
