// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/narrowing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

constexpr double kStepM = 0.1;
constexpr std::array<double, 3> kPeakWithinM{1.5, 3.0, kNarrowingReachM};
constexpr std::array<double, 2> kAreaWithinM{3.0, kNarrowingReachM};

/// What a walk has come by so far.
struct WalkedPlaces {
    float peak_m = 0.0F;
    double count = 0.0;
    double sum_squares = 0.0;

    void add(float clearance_m, float aside) {
        peak_m = std::max(peak_m, clearance_m);
        sum_squares += static_cast<double>(aside) * aside;
        count += 1.0;
    }
    /// All paths up to this length have been walked.
    void note(double path_m, double step_m, SideOfSaddle& side) const {
        for (std::size_t i = 0; i < kPeakWithinM.size(); ++i) {
            if (path_m <= kPeakWithinM[i]) side.peak_m[i] = static_cast<double>(peak_m);
        }
        for (std::size_t i = 0; i < kAreaWithinM.size(); ++i) {
            if (path_m > kAreaWithinM[i]) continue;
            side.area_m2[i] = count * step_m * step_m;
            side.spread_m[i] = std::sqrt(sum_squares / count) * step_m;
        }
    }
};

std::int32_t stride_of(double resolution_m) {
    return std::max(1, static_cast<std::int32_t>(std::lround(kStepM / resolution_m)));
}

}  // namespace

NarrowingGauge::NarrowingGauge(const Raster<float>& clearance_m, double resolution_m)
    : clearance_(clearance_m),
      resolution_m_(resolution_m),
      stride_cells_(stride_of(resolution_m)),
      step_m_(stride_cells_ * resolution_m),
      radius_(static_cast<std::int32_t>(std::ceil(kNarrowingReachM / step_m_)) + 2),
      row_bits_(static_cast<unsigned>(std::bit_width(2U * static_cast<unsigned>(radius_)))),
      places_((2U * static_cast<std::size_t>(radius_) + 1) << row_bits_),
      buckets_(static_cast<std::size_t>(5.0 * kNarrowingReachM / step_m_) + 10) {}

/// Nearest places first (Dial's buckets). No path is long enough to leave the window.
SideOfSaddle NarrowingGauge::walk_outward(Cell seed, const Direction& along,
                                          const RegionsView& regions) {
    constexpr auto kUnreached = static_cast<std::uint32_t>(-1);
    const std::uint32_t region = regions.region_at(clearance_.offset(seed));
    const std::uint32_t row_mask = (1U << row_bits_) - 1;
    const auto enter = [&](Place& place, std::uint32_t at) {
        place.walk = walk_;
        place.length = 0;
        const std::int32_t x = static_cast<std::int32_t>(at & row_mask) - radius_;
        const std::int32_t y = static_cast<std::int32_t>(at >> row_bits_) - radius_;
        const Cell cell{seed.x + x * stride_cells_, seed.y + y * stride_cells_};
        if (!clearance_.contains(cell)) return;
        const std::size_t offset = clearance_.offset(cell);
        if (regions.region_at(offset) != region) return;
        place.length = kUnreached;
        place.clearance_m = clearance_.values[offset];
        place.aside = static_cast<float>(x * along.x + y * along.y);
    };
    const auto reach = [&](std::uint32_t at, std::uint32_t length) {
        Place& place = places_[at];
        if (place.walk != walk_) enter(place, at);
        if (length >= place.length) return;
        place.length = length;
        buckets_[length].push_back(at);
    };
    ++walk_;
    for (auto& bucket : buckets_) bucket.clear();
    // The length 0 means something else.
    constexpr std::uint32_t kStart = 1;
    const auto centre = static_cast<std::uint32_t>(radius_);
    reach((centre << row_bits_) + centre, kStart);
    const std::uint32_t up = 1U << row_bits_;
    WalkedPlaces walked;
    SideOfSaddle side;
    for (std::uint32_t length = kStart; length + 8 < buckets_.size(); ++length) {
        for (std::size_t i = 0; i < buckets_[length].size(); ++i) {
            const std::uint32_t at = buckets_[length][i];
            const Place& place = places_[at];
            if (place.length != length) continue;
            walked.add(place.clearance_m, place.aside);
            for (const std::uint32_t next : {at - 1, at + 1, at - up, at + up}) {
                reach(next, length + 5);
            }
            for (const std::uint32_t next : {at - up - 1, at - up + 1, at + up - 1, at + up + 1}) {
                reach(next, length + 7);
            }
        }
        const double path_m = static_cast<double>(length - kStart) * step_m_ / 5.0;
        if (!buckets_[length].empty()) side.reach_m = path_m;
        walked.note(path_m, step_m_, side);
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
