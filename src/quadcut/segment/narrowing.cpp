// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/narrowing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

constexpr double kStepM = 0.1;
constexpr std::array<double, 3> kPeakWithinM{1.5, 3.0, kNarrowingReachM};
constexpr std::array<double, 2> kAreaWithinM{3.0, kNarrowingReachM};

std::int32_t stride_of(double resolution_m) {
    return std::max(1, static_cast<std::int32_t>(std::lround(kStepM / resolution_m)));
}

}  // namespace

NarrowingGauge::NarrowingGauge(const Raster<float>& clearance_m, double resolution_m)
    : clearance_(clearance_m),
      resolution_m_(resolution_m),
      stride_cells_(stride_of(resolution_m)),
      step_m_(stride_cells_ * resolution_m),
      radius_(static_cast<std::int32_t>(std::ceil(kNarrowingReachM / step_m_)) + 1),
      side_(2 * radius_ + 1),
      seen_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0),
      buckets_(static_cast<std::size_t>(5.0 * kNarrowingReachM / step_m_) + 9) {}

/// Nearest places first (Dial's buckets).
SideOfSaddle NarrowingGauge::walk_outward(Cell seed, const Direction& along,
                                          const RegionsView& regions) {
    const std::uint32_t region = regions.region_at(clearance_.offset(seed));
    SideOfSaddle side;
    std::array<double, 2> sum_squares{};
    const auto visit = [&](std::uint32_t place, std::size_t length) {
        if (std::exchange(seen_[place], walk_) == walk_) return;
        const std::int32_t x = static_cast<std::int32_t>(place) % side_ - radius_;
        const std::int32_t y = static_cast<std::int32_t>(place) / side_ - radius_;
        const double path_m = static_cast<double>(length) * step_m_ / 5.0;
        const double height_m =
            clearance_.at({seed.x + x * stride_cells_, seed.y + y * stride_cells_});
        for (std::size_t i = 0; i < kPeakWithinM.size(); ++i) {
            if (path_m <= kPeakWithinM[i]) side.peak_m[i] = std::max(side.peak_m[i], height_m);
        }
        const double aside_m = (x * along.x + y * along.y) * step_m_;
        for (std::size_t i = 0; i < kAreaWithinM.size(); ++i) {
            if (path_m > kAreaWithinM[i]) continue;
            side.area_m2[i] += step_m_ * step_m_;
            sum_squares[i] += aside_m * aside_m * step_m_ * step_m_;
        }
        side.reach_m = path_m;
        for (std::int32_t dy = -1; dy <= 1; ++dy) {
            for (std::int32_t dx = -1; dx <= 1; ++dx) {
                if (std::abs(x + dx) > radius_ || std::abs(y + dy) > radius_) continue;
                const std::uint32_t next = place + static_cast<std::uint32_t>(dy * side_ + dx);
                const Cell cell{seed.x + (x + dx) * stride_cells_,
                                seed.y + (y + dy) * stride_cells_};
                if (seen_[next] == walk_ || !clearance_.contains(cell) ||
                    regions.region_at(clearance_.offset(cell)) != region) {
                    continue;
                }
                buckets_[length + (dx != 0 && dy != 0 ? 7U : 5U)].push_back(next);
            }
        }
    };
    ++walk_;
    for (auto& bucket : buckets_) bucket.clear();
    buckets_[0].push_back(static_cast<std::uint32_t>(radius_ * side_ + radius_));
    for (std::size_t length = 0; length + 8 < buckets_.size(); ++length) {
        for (std::size_t i = 0; i < buckets_[length].size(); ++i) {
            visit(buckets_[length][i], length);
        }
    }
    for (std::size_t i = 0; i < sum_squares.size(); ++i) {
        side.spread_m[i] = std::sqrt(sum_squares[i] / side.area_m2[i]);
    }
    return side;
}

Narrowing NarrowingGauge::measure(const Saddle& saddle, const RegionsView& regions) {
    Narrowing out;
    out.half_width_m = static_cast<double>(saddle.clearance_m);
    out.opening = measure_opening(clearance_, resolution_m_, saddle);
    out.narrower = walk_outward(saddle.a, out.opening.along, regions);
    out.wider = walk_outward(saddle.b, out.opening.along, regions);
    out.is_a_narrower = out.narrower.peak_m.back() <= out.wider.peak_m.back();
    if (!out.is_a_narrower) std::swap(out.narrower, out.wider);
    out.border_ratio =
        static_cast<double>(saddle.num_contacts) * resolution_m_ / (2.0 * out.half_width_m);
    return out;
}

}  // namespace quadcut
