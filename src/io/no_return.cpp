// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/no_return.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace quadcut::io {
namespace {

constexpr double kBinsPerMetre = 50.0;
constexpr double kSpikeWidth = 0.02;
constexpr std::size_t kSpacing = 5;  // The stretch below the spike is as many times as wide.
constexpr std::uint64_t kDensityRatio = 4;
constexpr std::uint64_t kMinCount = 8;
constexpr double kMinShare = 0.002;
constexpr double kMaxShare = 0.9;
constexpr double kStrayShare = 0.0005;
constexpr double kMinSpike = 4.0;

}  // namespace

NoReturnFinder::NoReturnFinder()
    : counts_(static_cast<std::size_t>(kMaxUsableRange * kBinsPerMetre), 0) {}

void NoReturnFinder::add(std::span<const float> ranges_m) {
    for (const float range : ranges_m) {
        if (!std::isfinite(range) || range <= 0.0F) continue;
        ++num_readings_;
        const double bin = static_cast<double>(range) * kBinsPerMetre;
        if (bin < static_cast<double>(counts_.size())) ++counts_[static_cast<std::size_t>(bin)];
    }
}

double NoReturnFinder::limit_m() const {
    const auto sum = [this](std::size_t first, std::size_t last) {
        const auto begin = counts_.begin();
        return std::accumulate(begin + static_cast<std::ptrdiff_t>(first),
                               begin + static_cast<std::ptrdiff_t>(last), std::uint64_t{0});
    };
    const auto num_readings = static_cast<double>(num_readings_);
    std::uint64_t num_above = 0;
    for (std::size_t end = counts_.size(); end > 0; --end) {
        const std::uint64_t count_at_end = counts_[end - 1];
        if (count_at_end == 0) continue;
        const auto width = std::max<std::size_t>(
            2, static_cast<std::size_t>(std::ceil(kSpikeWidth * static_cast<double>(end))));
        if (static_cast<double>(end) < kMinSpike * kBinsPerMetre) break;
        const std::uint64_t in_spike = sum(end - width, end);
        const std::uint64_t below = sum(end - (kSpacing + 1) * width, end - width);
        const double share = static_cast<double>(in_spike) / num_readings;
        if (in_spike >= kMinCount && share >= kMinShare && share <= kMaxShare &&
            in_spike * kSpacing >= kDensityRatio * below) {
            return static_cast<double>(end - width) / kBinsPerMetre;
        }
        num_above += count_at_end;
        if (static_cast<double>(num_above) > kStrayShare * num_readings) break;
    }
    return kMaxUsableRange;
}

}  // namespace quadcut::io
