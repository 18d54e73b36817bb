// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/narrowing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

constexpr std::array<double, 3> kPeakWithinM{1.5, 3.0, 5.0};
constexpr std::array<double, 2> kAreaWithinM{3.0, 5.0};
constexpr double kFarM = 5.0;

}  // namespace

NarrowingGauge::NarrowingGauge(const Raster<float>& clearance_m, double resolution_m)
    : clearance_(clearance_m),
      resolution_m_(resolution_m),
      unit_m_(resolution_m / 5.0),
      radius_(static_cast<std::int32_t>(std::ceil(kFarM / resolution_m)) + 1),
      side_(static_cast<std::size_t>(2 * radius_ + 1)),
      seen_(side_ * side_, 0),
      buckets_(static_cast<std::size_t>(kFarM / unit_m_) + 9) {}

/// Nearest cells first (Dial's buckets).
SideOfSaddle NarrowingGauge::walk_outward(Cell seed, const RegionsView& regions) {
    const std::uint32_t region = regions.region_at(clearance_.offset(seed));
    const auto slot_of = [&](Cell at) {
        return static_cast<std::size_t>(at.y - seed.y + radius_) * side_ +
               static_cast<std::size_t>(at.x - seed.x + radius_);
    };
    SideOfSaddle side;
    const auto visit = [&](Cell cell, std::size_t steps) {
        if (std::exchange(seen_[slot_of(cell)], walk_) == walk_) return;
        const double path_m = static_cast<double>(steps) * unit_m_;
        const double height_m = clearance_.at(cell);
        for (std::size_t i = 0; i < kPeakWithinM.size(); ++i) {
            if (path_m <= kPeakWithinM[i]) side.peak_m[i] = std::max(side.peak_m[i], height_m);
        }
        for (std::size_t i = 0; i < kAreaWithinM.size(); ++i) {
            if (path_m <= kAreaWithinM[i]) side.area_m2[i] += resolution_m_ * resolution_m_;
        }
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
    };
    ++walk_;
    for (auto& bucket : buckets_) bucket.clear();
    buckets_[0].push_back(seed);
    const auto last = static_cast<std::size_t>(kFarM / unit_m_);
    for (std::size_t steps = 0; steps <= last; ++steps) {
        for (std::size_t i = 0; i < buckets_[steps].size(); ++i) visit(buckets_[steps][i], steps);
    }
    return side;
}

Narrowing NarrowingGauge::measure(const Saddle& saddle, const RegionsView& regions) {
    Narrowing out;
    out.half_width_m = static_cast<double>(saddle.clearance_m);
    out.narrower = walk_outward(saddle.a, regions);
    out.wider = walk_outward(saddle.b, regions);
    if (out.narrower.peak_m.back() > out.wider.peak_m.back()) std::swap(out.narrower, out.wider);
    out.border_ratio =
        static_cast<double>(saddle.num_contacts) * resolution_m_ / (2.0 * out.half_width_m);
    out.opening = measure_opening(clearance_, resolution_m_, saddle);
    return out;
}

}  // namespace quadcut
