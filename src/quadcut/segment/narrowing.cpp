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
      places_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)),
      buckets_(static_cast<std::size_t>(5.0 * kNarrowingReachM / step_m_) + 10) {}

/// Nearest places first (Dial's buckets).
SideOfSaddle NarrowingGauge::walk_outward(Cell seed, const Direction& along,
                                          const RegionsView& regions) {
    constexpr auto kUnreached = static_cast<std::uint32_t>(-1);
    const std::uint32_t region = regions.region_at(clearance_.offset(seed));
    const auto reach = [&](std::int32_t x, std::int32_t y, std::size_t length) {
        if (std::abs(x) > radius_ || std::abs(y) > radius_) return;
        const auto at = static_cast<std::uint32_t>((y + radius_) * side_ + x + radius_);
        Place& place = places_[at];
        if (std::exchange(place.walk, walk_) != walk_) {
            const Cell cell{seed.x + x * stride_cells_, seed.y + y * stride_cells_};
            const bool is_inside = clearance_.contains(cell) &&
                                   regions.region_at(clearance_.offset(cell)) == region;
            place.length = is_inside ? kUnreached : 0;
        }
        if (length >= place.length) return;
        place.length = static_cast<std::uint32_t>(length);
        buckets_[length].push_back(at);
    };
    ++walk_;
    for (auto& bucket : buckets_) bucket.clear();
    // The length 0 means something else.
    constexpr std::size_t kStart = 1;
    reach(0, 0, kStart);
    SideOfSaddle side;
    double peak_m = 0.0;
    double num_places = 0.0;
    double sum_squares = 0.0;
    for (std::size_t length = kStart; length + 8 < buckets_.size(); ++length) {
        for (std::size_t i = 0; i < buckets_[length].size(); ++i) {
            const std::uint32_t at = buckets_[length][i];
            if (places_[at].length != length) continue;
            const std::int32_t x = static_cast<std::int32_t>(at) % side_ - radius_;
            const std::int32_t y = static_cast<std::int32_t>(at) / side_ - radius_;
            const Cell cell{seed.x + x * stride_cells_, seed.y + y * stride_cells_};
            peak_m = std::max(peak_m, static_cast<double>(clearance_.at(cell)));
            const double aside = x * along.x + y * along.y;
            sum_squares += aside * aside;
            num_places += 1.0;
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                for (std::int32_t dx = -1; dx <= 1; ++dx) {
                    reach(x + dx, y + dy, length + (dx != 0 && dy != 0 ? 7U : 5U));
                }
            }
        }
        const double path_m = static_cast<double>(length - kStart) * step_m_ / 5.0;
        if (!buckets_[length].empty()) side.reach_m = path_m;
        for (std::size_t i = 0; i < kPeakWithinM.size(); ++i) {
            if (path_m <= kPeakWithinM[i]) side.peak_m[i] = peak_m;
        }
        for (std::size_t i = 0; i < kAreaWithinM.size(); ++i) {
            if (path_m > kAreaWithinM[i]) continue;
            side.area_m2[i] = num_places * step_m_ * step_m_;
            side.spread_m[i] = std::sqrt(sum_squares / num_places) * step_m_;
        }
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
