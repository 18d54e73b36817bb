// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/wall_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

/// Lines are bands so wide, one every half of it.
constexpr double kBandM = 0.2;
/// No robot fits through what is narrower: pieces so near each other are one wall.
constexpr double kJoinedM = 0.35;
/// A shorter piece is no wall.
constexpr double kMinWallM = 0.5;
/// One that goes on up to something else than a wall is longer.
constexpr double kMinWallAloneM = 1.2;
/// From this length on pieces in line are a wall, whatever they are.
constexpr double kMinPiecesM = 1.5;
/// Of the length of a wall, at least this share is seen.
constexpr double kMinSeen = 0.35;
/// Of two lines nearer to each other the better one counts.
constexpr double kApartM = 0.4;
constexpr double kMaxLengthM = 25.0;
constexpr int kNumAngles = 90;
constexpr std::size_t kMaxSampled = 8000;
constexpr std::size_t kMaxDirections = 4;
/// Another direction has at least this share of the strongest one's excess over the median.
constexpr double kMinStrength = 0.25;
constexpr int kApartAngles = 10;

/// Obstacle cells beside free ones: their middles, in cells.
std::vector<Point> surfaces(const Raster<std::uint8_t>& free) {
    std::vector<Point> points;
    const auto width = static_cast<std::size_t>(free.width);
    const auto is_free = [&](std::size_t i) { return free.values[i] != 0; };
    for (std::size_t i = 0; i < free.values.size(); ++i) {
        if (is_free(i)) continue;
        const std::size_t x = i % width;
        if ((x > 0 && is_free(i - 1)) || (x + 1 < width && is_free(i + 1)) ||
            (i >= width && is_free(i - width)) ||
            (i + width < free.values.size() && is_free(i + width))) {
            const std::size_t y = i / width;
            points.push_back({static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5});
        }
    }
    return points;
}

/// How unevenly points project onto an axis.
double concentration(const std::vector<Point>& points, std::size_t stride, const Point& axis,
                     double bin_cells, std::vector<std::uint32_t>& bins) {
    std::fill(bins.begin(), bins.end(), 0U);
    const double middle = 0.5 * static_cast<double>(bins.size());
    for (std::size_t i = 0; i < points.size(); i += stride) {
        const double at = (points[i].x * axis.x + points[i].y * axis.y) / bin_cells;
        ++bins[static_cast<std::size_t>(at + middle)];
    }
    double sum = 0.0;
    for (const std::uint32_t count : bins) sum += static_cast<double>(count) * count;
    return sum;
}

std::vector<double> directions_of(const std::vector<Point>& points, double resolution_m,
                                  double extent_cells) {
    if (points.empty()) return {};
    const double bin_cells = 0.5 * kBandM / resolution_m;
    std::vector<std::uint32_t> bins(static_cast<std::size_t>(2.0 * extent_cells / bin_cells) + 8);
    const std::size_t stride = 1 + points.size() / kMaxSampled;
    std::array<double, kNumAngles> strength{};
    for (int k = 0; k < kNumAngles; ++k) {
        const double angle = 0.5 * std::numbers::pi * k / kNumAngles;
        const Point along{std::cos(angle), std::sin(angle)};
        strength[static_cast<std::size_t>(k)] =
            concentration(points, stride, along, bin_cells, bins) +
            concentration(points, stride, {-along.y, along.x}, bin_cells, bins);
    }
    std::array<double, kNumAngles> ordered = strength;
    std::nth_element(ordered.begin(), ordered.begin() + kNumAngles / 2, ordered.end());
    const double median = ordered[kNumAngles / 2];
    std::vector<int> chosen;
    while (chosen.size() < kMaxDirections) {
        int best = -1;
        for (int k = 0; k < kNumAngles; ++k) {
            const bool is_apart = std::all_of(chosen.begin(), chosen.end(), [&](int other) {
                const int between = std::abs(k - other);
                return std::min(between, kNumAngles - between) >= kApartAngles;
            });
            if (is_apart && (best < 0 || strength[static_cast<std::size_t>(k)] >
                                             strength[static_cast<std::size_t>(best)])) {
                best = k;
            }
        }
        const auto excess = [&](int k) { return strength[static_cast<std::size_t>(k)] - median; };
        if (best < 0 || (!chosen.empty() && excess(best) < kMinStrength * excess(chosen[0]))) break;
        chosen.push_back(best);
    }
    std::vector<double> angles;
    for (const int k : chosen) angles.push_back(0.5 * std::numbers::pi * k / kNumAngles);
    return angles;
}

/// A stretch of a band, in cells along it.
struct Run {
    double begin = 0.0;
    double end = 0.0;
    /// Of its length, how much is seen.
    double seen = 0.0;
};

/// A gap of a wall; lengths in metres.
struct Gap {
    std::size_t direction = 0;
    std::int32_t band = 0;
    double begin = 0.0;
    double end = 0.0;
    double less_m = 0.0;
    double more_m = 0.0;
    [[nodiscard]] double strength() const { return more_m + 2.0 * less_m; }
};

/// The gaps of the walls in one direction.
class Bands {
public:
    Bands(const std::vector<Point>& points, const Point& along, double resolution_m,
          double max_gap_m)
        : along_(along),
          resolution_m_(resolution_m),
          max_gap_(max_gap_m / resolution_m),
          step_(0.5 * kBandM / resolution_m) {
        fill(points);
    }
    /// The line in the middle of a band, where t = 0.
    [[nodiscard]] Point middle_of(std::int32_t band) const {
        const double offset = (band + 1) * step_;
        return {-along_.y * offset, along_.x * offset};
    }
    [[nodiscard]] const Point& along() const { return along_; }
    WallsAlong find_gaps(std::size_t direction, std::vector<Gap>& gaps) {
        WallsAlong walls{along_, step_, lowest_, {}};
        walls.bands.resize(first_.empty() ? 0 : first_.size() - 1);
        for (std::size_t k = 0; k + 1 < first_.size(); ++k) {
            const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(first_[k]);
            const auto end = places_.begin() + static_cast<std::ptrdiff_t>(first_[k + 1]);
            if (begin == end) continue;
            std::sort(begin, end);
            const std::vector<Run> runs = runs_of(begin, end);
            add_gaps(runs, direction, static_cast<std::int32_t>(k) + lowest_, gaps);
            for (const Run& run : runs) {
                if (wall_m(run) >= kMinPiecesM) walls.bands[k].push_back({run.begin, run.end});
            }
        }
        return walls;
    }

private:
    using Place = std::vector<float>::iterator;

    /// Each point is in two bands: those that begin at its step and at the one before.
    void fill(const std::vector<Point>& points) {
        if (points.empty()) return;
        std::vector<std::int32_t> step_of;
        step_of.reserve(points.size());
        for (const Point& point : points) {
            step_of.push_back(static_cast<std::int32_t>(
                std::floor((point.y * along_.x - point.x * along_.y) / step_)));
        }
        const auto [low, high] = std::minmax_element(step_of.begin(), step_of.end());
        lowest_ = *low - 1;
        first_.assign(static_cast<std::size_t>(*high - lowest_) + 1, 0);
        std::vector<std::size_t> at(first_.size(), 0);
        std::vector<std::size_t> count(first_.size(), 0);
        for (const std::int32_t step : step_of) {
            for (const std::int32_t band : {step - 1, step}) {
                ++count[static_cast<std::size_t>(band - lowest_)];
            }
        }
        std::size_t begin = 0;
        for (std::size_t k = 0; k < first_.size(); ++k) {
            first_[k] = begin;
            at[k] = begin;
            begin += count[k];
        }
        places_.resize(begin);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto t = static_cast<float>(points[i].x * along_.x + points[i].y * along_.y);
            for (const std::int32_t band : {step_of[i] - 1, step_of[i]}) {
                places_[at[static_cast<std::size_t>(band - lowest_)]++] = t;
            }
        }
        first_.push_back(begin);
    }

    [[nodiscard]] std::vector<Run> runs_of(Place begin, Place end) const {
        const double joined = kJoinedM / resolution_m_;
        std::vector<Run> runs;
        for (Place at = begin; at != end; ++at) {
            const double t = static_cast<double>(*at);
            if (runs.empty() || t - runs.back().end > joined) {
                runs.push_back({t - 0.5, t + 0.5, 1.0});
                continue;
            }
            runs.back().seen += std::min(1.0, t + 0.5 - runs.back().end);
            runs.back().end = t + 0.5;
        }
        return runs;
    }
    [[nodiscard]] double wall_m(const Run& run) const {
        const double length_m = (run.end - run.begin) * resolution_m_;
        const bool is_wall = length_m >= kMinWallM && run.seen >= kMinSeen * (run.end - run.begin);
        return is_wall ? std::min(length_m, kMaxLengthM) : 0.0;
    }
    void add_gaps(const std::vector<Run>& runs, std::size_t direction, std::int32_t band,
                  std::vector<Gap>& gaps) const {
        for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
            if (runs[i + 1].begin - runs[i].end > max_gap_) continue;
            const double before_m = wall_m(runs[i]);
            const double after_m = wall_m(runs[i + 1]);
            const bool is_alone = before_m == 0.0 || after_m == 0.0;
            if (std::max(before_m, after_m) < (is_alone ? kMinWallAloneM : kMinWallM)) continue;
            gaps.push_back({direction, band, runs[i].end, runs[i + 1].begin,
                            std::min(before_m, after_m), std::max(before_m, after_m)});
        }
    }

    Point along_;
    double resolution_m_;
    double max_gap_;
    double step_;
    std::int32_t lowest_ = 0;
    std::vector<std::size_t> first_;
    std::vector<float> places_;
};

/// Draws gaps into the free cells, the strongest first.
class Painter {
public:
    Painter(const Raster<std::uint8_t>& free, double resolution_m, WallLines& lines)
        : free_(free), apart_(static_cast<std::int32_t>(kApartM / resolution_m)), lines_(lines) {}

    void paint(const Gap& gap, const Bands& bands) {
        const Point middle = bands.middle_of(gap.band);
        const Point along = bands.along();
        const auto point_at = [&](double t) {
            return Point{middle.x + t * along.x, middle.y + t * along.y};
        };
        std::vector<Cell> cells;
        std::size_t num_taken = 0;
        // From the middle of the gap outward, up to obstacles.
        const double centre = 0.5 * (gap.begin + gap.end);
        for (const double sign : {1.0, -1.0}) {
            const double limit = 0.5 * (gap.end - gap.begin) + apart_;
            Cell last = cell_of(point_at(centre));
            for (double t = 0.0; t <= limit; t += 0.5) {
                const Cell cell = cell_of(point_at(centre + sign * t));
                if (!free_.contains(cell) || free_.at(cell) == 0) break;
                if (cell.x != last.x && cell.y != last.y) add({cell.x, last.y}, cells, num_taken);
                if (t == 0.0 || !(cell == last)) add(cell, cells, num_taken);
                last = cell;
            }
        }
        if (cells.empty() || 3 * num_taken > cells.size()) return;
        const auto dm = [](double m) { return static_cast<std::uint8_t>(std::lround(10.0 * m)); };
        for (const Cell cell : cells) {
            if (lines_.more_dm.at(cell) != 0) continue;
            lines_.less_dm.at(cell) = dm(gap.less_m);
            lines_.more_dm.at(cell) = dm(gap.more_m);
        }
    }

private:
    void add(Cell cell, std::vector<Cell>& cells, std::size_t& num_taken) const {
        if (!free_.contains(cell) || free_.at(cell) == 0) return;
        cells.push_back(cell);
        for (std::int32_t d = -apart_; d <= apart_; ++d) {
            for (const Cell near : {Cell{cell.x + d, cell.y}, Cell{cell.x, cell.y + d}}) {
                if (lines_.more_dm.contains(near) && lines_.more_dm.at(near) != 0) {
                    ++num_taken;
                    return;
                }
            }
        }
    }

    const Raster<std::uint8_t>& free_;
    std::int32_t apart_;
    WallLines& lines_;
};

}  // namespace

bool WallsAlong::contains(const Point& at) const {
    const double t = at.x * along.x + at.y * along.y;
    const auto step =
        static_cast<std::int32_t>(std::floor((at.y * along.x - at.x * along.y) / step_cells));
    for (const std::int32_t band : {step - 1, step}) {
        const auto k = static_cast<std::size_t>(band - lowest);
        if (band < lowest || k >= bands.size()) continue;
        const auto after = std::upper_bound(
            bands[k].begin(), bands[k].end(), t,
            [](double place, const Stretch& stretch) { return place < stretch.begin; });
        if (after != bands[k].begin() && t <= std::prev(after)->end) return true;
    }
    return false;
}

bool WallLines::is_wall(const Point& at) const {
    return std::any_of(walls.begin(), walls.end(),
                       [&](const WallsAlong& along) { return along.contains(at); });
}

std::vector<double> main_directions(const Raster<std::uint8_t>& free, double resolution_m) {
    return directions_of(surfaces(free), resolution_m, std::hypot(free.width, free.height) + 2.0);
}

WallLines find_wall_lines(const Raster<std::uint8_t>& free, double resolution_m, double max_gap_m,
                          const Executor& executor) {
    WallLines lines{{}, Raster<std::uint8_t>(free.box()), Raster<std::uint8_t>(free.box())};
    const std::vector<Point> points = surfaces(free);
    const std::vector<double> angles =
        directions_of(points, resolution_m, std::hypot(free.width, free.height) + 2.0);
    std::vector<Bands> bands;
    for (const double angle : angles) {
        const Point along{std::cos(angle), std::sin(angle)};
        bands.emplace_back(points, along, resolution_m, max_gap_m);
        bands.emplace_back(points, Point{-along.y, along.x}, resolution_m, max_gap_m);
    }
    std::vector<std::vector<Gap>> found(bands.size());
    lines.walls.resize(bands.size());
    parallel_for(executor, bands.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            lines.walls[k] = bands[k].find_gaps(k, found[k]);
        }
    });
    std::vector<Gap> gaps;
    for (const auto& some : found) gaps.insert(gaps.end(), some.begin(), some.end());
    std::stable_sort(gaps.begin(), gaps.end(),
                     [](const Gap& p, const Gap& q) { return p.strength() > q.strength(); });
    Painter painter(free, resolution_m, lines);
    for (const Gap& gap : gaps) painter.paint(gap, bands[gap.direction]);
    return lines;
}

}  // namespace quadcut
