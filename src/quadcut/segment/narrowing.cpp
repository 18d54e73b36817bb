// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/narrowing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadcut {
namespace {

constexpr double kNearM = 3.0;
constexpr double kFarM = 5.0;
const double kLogNarrowerMax = std::log(1.6);
const double kLogWiderMax = std::log(2.2);
constexpr double kDepthMax = 4.0;

bool is_open(const Raster<float>& clearance, Cell cell) {
    return clearance.contains(cell) && clearance.at(cell) > 0.0F;
}

struct Vector {
    double x = 0.0;
    double y = 0.0;
    [[nodiscard]] double length() const { return std::hypot(x, y); }
};

Vector between(Cell from, Cell to) {
    return {static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
}

/// The obstacle cell nearest to the saddle, and the nearest one on the other side of it: more than
/// 120 degrees away from the first, within 1.6 h.
void find_jambs(const Raster<float>& clearance, double resolution_m, const Saddle& saddle,
                Narrowing& out) {
    const double h_cells = static_cast<double>(saddle.clearance_m) / resolution_m + 0.5;
    const auto radius = static_cast<std::int32_t>(std::ceil(1.6 * h_cells + 1.0));
    std::vector<std::pair<double, Cell>> blocked;
    for (std::int32_t dy = -radius; dy <= radius; ++dy) {
        for (std::int32_t dx = -radius; dx <= radius; ++dx) {
            const Cell cell{saddle.a.x + dx, saddle.a.y + dy};
            const double length = std::hypot(dx, dy);
            if (length > 1.6 * h_cells + 1.0 || is_open(clearance, cell)) continue;
            blocked.emplace_back(length, cell);
        }
    }
    if (blocked.empty()) return;
    const auto nearest =
        std::min_element(blocked.begin(), blocked.end(),
                         [](const auto& p, const auto& q) { return p.first < q.first; });
    const Vector first = between(saddle.a, nearest->second);
    const std::pair<double, Cell>* opposite = nullptr;
    for (const auto& candidate : blocked) {
        const Vector v = between(saddle.a, candidate.second);
        const double cosine =
            (v.x * first.x + v.y * first.y) / std::max(1e-9, v.length() * first.length());
        if (cosine > -0.5) continue;
        if (opposite == nullptr || candidate.first < opposite->first) opposite = &candidate;
    }
    if (opposite == nullptr) return;
    out.jambs = {nearest->second, opposite->second};
    out.has_jambs = true;
}

/// Walks from a jamb away from the opening, along the line of the opening, up to 0.6 m, and notes
/// how much of the way is wall with free space within 0.4 m on its left, its right, and both.
struct WallRun {
    double left_m = 0.0;
    double right_m = 0.0;
    double both_m = 0.0;
};

WallRun walk_along_wall(const Raster<float>& clearance, double resolution_m, Cell jamb,
                        const Vector& direction) {
    WallRun run;
    const Vector left{-direction.y, direction.x};
    const auto free_beside = [&](double x, double y, double sign) {
        for (double t = 1.0; t <= 0.4 / resolution_m; t += 1.0) {
            const Cell cell{static_cast<std::int32_t>(std::floor(x + sign * t * left.x)),
                            static_cast<std::int32_t>(std::floor(y + sign * t * left.y))};
            if (is_open(clearance, cell)) return true;
        }
        return false;
    };
    for (double t = 0.0; t <= 0.6 / resolution_m; t += 1.0) {
        const double x = jamb.x + 0.5 + t * direction.x;
        const double y = jamb.y + 0.5 + t * direction.y;
        const Cell cell{static_cast<std::int32_t>(std::floor(x)),
                        static_cast<std::int32_t>(std::floor(y))};
        if (is_open(clearance, cell)) break;
        const bool on_left = free_beside(x, y, 1.0);
        const bool on_right = free_beside(x, y, -1.0);
        if (on_left) run.left_m += resolution_m;
        if (on_right) run.right_m += resolution_m;
        if (on_left && on_right) run.both_m += resolution_m;
    }
    return run;
}

void measure_jambs(const Raster<float>& clearance, double resolution_m, const Saddle& saddle,
                   Narrowing& out) {
    find_jambs(clearance, resolution_m, saddle, out);
    if (!out.has_jambs) return;
    Vector along = between(out.jambs[0], out.jambs[1]);
    const double length = along.length();
    if (length == 0.0) return;
    along = {along.x / length, along.y / length};
    const WallRun end = walk_along_wall(clearance, resolution_m, out.jambs[1], along);
    // Seen from the other end, left and right change places.
    const WallRun start =
        walk_along_wall(clearance, resolution_m, out.jambs[0], {-along.x, -along.y});
    out.jamb_m = std::min(end.both_m, 0.4) + std::min(start.both_m, 0.4);
    out.flush_m = std::min(
        0.5, std::max(std::min(end.left_m, start.right_m), std::min(end.right_m, start.left_m)));
}

}  // namespace

NarrowingGauge::NarrowingGauge(const Raster<float>& clearance_m, double resolution_m)
    : clearance_(clearance_m),
      resolution_m_(resolution_m),
      unit_m_(resolution_m / 5.0),
      radius_(static_cast<std::int32_t>(std::ceil(kFarM / resolution_m)) + 1),
      side_(static_cast<std::size_t>(2 * radius_ + 1)),
      seen_(side_ * side_, 0),
      buckets_(static_cast<std::size_t>(kFarM / unit_m_) + 9) {}

/// Nearest cells first (Dial's buckets), until what is found can change no score.
NarrowingGauge::Side NarrowingGauge::walk_outward(Cell seed, double half_width_m,
                                                  const RegionsView& regions) {
    Side side;
    const std::uint32_t region = regions.region_at(clearance_.offset(seed));
    const double enough_peak_m = half_width_m * std::exp(kLogWiderMax);
    const double enough_reach_m = half_width_m * 2.0 * kDepthMax;
    ++walk_;
    for (auto& bucket : buckets_) bucket.clear();
    buckets_[0].push_back(seed);
    const auto last = static_cast<std::size_t>(kFarM / unit_m_);
    for (std::size_t d = 0; d <= last; ++d) {
        for (std::size_t i = 0; i < buckets_[d].size(); ++i) {
            visit(buckets_[d][i], d, seed, region, regions, side);
        }
        if (side.peak_near_m >= enough_peak_m && side.reach_m >= enough_reach_m) break;
    }
    return side;
}

void NarrowingGauge::visit(Cell cell, std::size_t steps, Cell seed, std::uint32_t region,
                           const RegionsView& regions, Side& side) {
    const auto slot_of = [&](Cell at) {
        return static_cast<std::size_t>(at.y - seed.y + radius_) * side_ +
               static_cast<std::size_t>(at.x - seed.x + radius_);
    };
    std::uint32_t& seen = seen_[slot_of(cell)];
    if (seen == walk_) return;
    seen = walk_;
    const double path_m = static_cast<double>(steps) * unit_m_;
    const double height = clearance_.at(cell);
    if (path_m <= kNearM) side.peak_near_m = std::max(side.peak_near_m, height);
    side.peak_far_m = std::max(side.peak_far_m, height);
    side.reach_m = path_m;
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
            const Cell next{cell.x + dx, cell.y + dy};
            if (!clearance_.contains(next) || std::abs(next.x - seed.x) > radius_ ||
                std::abs(next.y - seed.y) > radius_ || seen_[slot_of(next)] == walk_ ||
                regions.region_at(clearance_.offset(next)) != region) {
                continue;
            }
            buckets_[steps + (dx != 0 && dy != 0 ? 7U : 5U)].push_back(next);
        }
    }
}

Narrowing NarrowingGauge::measure(const Saddle& saddle, const RegionsView& regions) {
    Narrowing out;
    const auto h = static_cast<double>(saddle.clearance_m);
    const Side a = walk_outward(saddle.a, h, regions);
    const Side b = walk_outward(saddle.b, h, regions);
    const Side& narrower = a.peak_far_m <= b.peak_far_m ? a : b;
    const Side& wider = a.peak_far_m <= b.peak_far_m ? b : a;
    out.narrower_side = std::clamp(std::log(narrower.peak_far_m / h), 0.0, kLogNarrowerMax);
    out.wider_side = std::clamp(std::log(wider.peak_near_m / h), 0.0, kLogWiderMax);
    out.depth = std::min(kDepthMax, narrower.reach_m / (2.0 * h));
    measure_jambs(clearance_, resolution_m_, saddle, out);
    return out;
}

double door_log_odds(const Narrowing& narrowing) {
    double log_odds = -6.2 + 2.5 * narrowing.narrower_side + 7.8 * narrowing.wider_side +
                      2.0 * narrowing.jamb_m + 2.0 * narrowing.flush_m;
    if (narrowing.depth < 1.5 && narrowing.narrower_side < 0.14) log_odds -= 3.0;
    return log_odds;
}

}  // namespace quadcut
