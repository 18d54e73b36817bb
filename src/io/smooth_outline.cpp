// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/smooth_outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <utility>

namespace quadcut::io {
namespace {

/// In half cells: a slanted line on the grid is a stair with steps of one cell.
constexpr std::int32_t kStep = 2;
/// Two steps the same way are one if they are at most this far apart; three are, however far.
constexpr std::int32_t kLongestLoneTread = 12;
/// Points closer than this to the line through their neighbours are dropped.
constexpr double kTolerance = 0.9;

using Line = std::vector<HalfCell>;

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// +1 left, -1 right, 0 straight.
int turn_at(HalfCell before, HalfCell here, HalfCell after) {
    return sign(std::int64_t{here.x - before.x} * (after.y - here.y) -
                std::int64_t{here.y - before.y} * (after.x - here.x));
}

/// From `a` towards `b`, which lies on the same row or column.
HalfCell toward(HalfCell a, HalfCell b, std::int32_t distance) {
    return {a.x + sign(b.x - a.x) * distance, a.y + sign(b.y - a.y) * distance};
}

/// The runs of a line, and which of them are steps of a stair.
class Stairs {
public:
    explicit Stairs(const Line& line) : line_(line), is_step_(line.size() - 1, false) {
        std::vector<bool> is_zigzag(num_runs(), false);
        for (std::size_t run = 1; run + 1 < num_runs(); ++run) {
            const int before = turn_at(line[run - 1], line[run], line[run + 1]);
            const int after = turn_at(line[run], line[run + 1], line[run + 2]);
            is_zigzag[run] = length(run) <= kStep && before * after < 0;
        }
        const auto goes_on = [&](std::size_t run) {  // At run + 2, the same way.
            return run + 3 < num_runs() && is_zigzag[run] && is_zigzag[run + 2] &&
                   line[run + 1].x - line[run].x == line[run + 3].x - line[run + 2].x &&
                   line[run + 1].y - line[run].y == line[run + 3].y - line[run + 2].y;
        };
        // One step alone is a jog in a wall.
        for (std::size_t run = 1; run + 1 < num_runs(); ++run) {
            if (!goes_on(run)) continue;
            const bool third = goes_on(run + 2) || (run > 2 && goes_on(run - 2));
            if (third || length(run + 1) <= kLongestLoneTread)
                is_step_[run] = is_step_[run + 2] = true;
        }
    }

    [[nodiscard]] std::size_t num_runs() const { return line_.size() - 1; }
    [[nodiscard]] bool is_step(std::size_t run) const { return is_step_[run]; }
    [[nodiscard]] std::int32_t length(std::size_t run) const {
        return std::abs(line_[run + 1].x - line_[run].x) +
               std::abs(line_[run + 1].y - line_[run].y);
    }

    /// Whether the slanted line passes by the corner between run - 1 and `run`.
    [[nodiscard]] bool cuts_corner(std::size_t run) const {
        return run > 0 && run < num_runs() && (is_step(run - 1) || is_step(run));
    }

    /// How far along `run`, from a corner that is cut, the slanted line lies: half the tread, but
    /// no farther than the treads next to it are long.
    [[nodiscard]] std::int32_t reach(std::size_t run) const {
        std::int32_t reach = length(run) / 2;
        if (run >= 2 && is_step(run - 1)) reach = std::min(reach, tread(run - 2));
        if (run + 2 < num_runs() && is_step(run + 1)) reach = std::min(reach, tread(run + 2));
        return reach;
    }

private:
    /// The length of a tread between two steps; a larger one than any if it is not.
    [[nodiscard]] std::int32_t tread(std::size_t run) const {
        const bool inner = run > 0 && run + 1 < num_runs() && is_step(run - 1) && is_step(run + 1);
        return inner ? length(run) : std::numeric_limits<std::int32_t>::max();
    }

    const Line& line_;
    std::vector<bool> is_step_;
};

/// Draws stairs as slanted lines.
Line without_stairs(const Line& line) {
    const Stairs stairs(line);
    Line result{line.front()};
    const auto add = [&result](HalfCell point) {
        if (result.back() != point) result.push_back(point);
    };
    for (std::size_t run = 0; run < stairs.num_runs(); ++run) {
        const HalfCell from = line[run];
        const HalfCell to = line[run + 1];
        const std::int32_t reach = stairs.reach(run);
        if (stairs.cuts_corner(run)) add(toward(from, to, reach));
        add(stairs.cuts_corner(run + 1) ? toward(to, from, reach) : to);
    }
    return result;
}

/// How far points lie from the line through two points, or from the point if they are one.
class DistanceToLine {
public:
    DistanceToLine(HalfCell a, HalfCell b)
        : a_(a), dx_(b.x - a.x), dy_(b.y - a.y), norm_(std::hypot(dx_, dy_)) {}
    [[nodiscard]] double operator()(HalfCell point) const {
        if (norm_ == 0.0) return std::hypot(point.x - a_.x, point.y - a_.y);
        return std::abs(dx_ * (point.y - a_.y) - dy_ * (point.x - a_.x)) / norm_;
    }

private:
    HalfCell a_;
    double dx_;
    double dy_;
    double norm_;
};

/// Douglas and Peucker 1973: keeps the ends, and the farthest point as long as it is too far.
Line without_small_bends(const Line& line) {
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const std::size_t first = open.back().first;
        const std::size_t last = open.back().second;
        open.pop_back();
        const DistanceToLine distance(line[first], line[last]);
        std::size_t farthest = first;
        double most = kTolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distance(line[i]);
            if (d > most) {
                most = d;
                farthest = i;
            }
        }
        if (farthest == first) continue;
        kept[farthest] = true;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    Line result;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (kept[i]) result.push_back(line[i]);
    }
    return result;
}

bool is_before(HalfCell a, HalfCell b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// Smooths the line between two junctions, or a closed one from its first point, the same way
/// whichever region walks along it.
Line smooth_line(Line line) {
    const HalfCell head = line.front() == line.back() ? line[1] : line.front();
    const HalfCell tail = line.front() == line.back() ? line[line.size() - 2] : line.back();
    const bool reversed = is_before(tail, head);
    if (reversed) std::reverse(line.begin(), line.end());
    line = without_small_bends(without_stairs(line));
    if (reversed) std::reverse(line.begin(), line.end());
    return line;
}

/// Where a ring is cut into lines: its junctions, or its lowest (then leftmost) point.
std::size_t find_start(const OutlineRing& ring) {
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (ring[i].is_junction) return i;
        if (std::pair(ring[i].y, ring[i].x) < std::pair(ring[lowest].y, ring[lowest].x)) lowest = i;
    }
    return lowest;
}

}  // namespace

std::vector<HalfCell> smooth_ring(const OutlineRing& ring) {
    const std::size_t start = find_start(ring);
    std::vector<HalfCell> result;
    Line line;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
        const OutlinePoint& point = ring[(start + i) % ring.size()];
        line.push_back({2 * point.x, 2 * point.y});
        const bool ends = i > 0 && (point.is_junction || i == ring.size());
        if (!ends) continue;
        const HalfCell last = line.back();
        line = smooth_line(std::move(line));
        result.insert(result.end(), line.begin(), line.end() - 1);
        line.assign(1, last);
    }
    return result;
}

double length_cells(const std::vector<HalfCell>& ring) {
    double half_cells = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const HalfCell a = ring[i];
        const HalfCell b = ring[(i + 1) % ring.size()];
        half_cells += std::hypot(b.x - a.x, b.y - a.y);
    }
    return half_cells / 2.0;
}

}  // namespace quadcut::io
