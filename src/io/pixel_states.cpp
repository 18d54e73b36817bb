// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/pixel_states.hpp"

#include <cmath>
#include <numeric>

namespace quadcut::io {
namespace {

CellState state_of_percent(double percent) {
    // map_saver's own defaults for turning 0 .. 100 into three states.
    constexpr double kOccupied = 65.0;
    constexpr double kFree = 25.0;
    if (percent >= kOccupied) return CellState::occupied;
    return percent <= kFree ? CellState::free : CellState::unknown;
}

}  // namespace

std::uint64_t GreyTally::count(int first, int last) const {
    return std::accumulate(counts.begin() + first, counts.begin() + last + 1, std::uint64_t{0});
}

CellState state_of_shade(double shade, const MapKeys& keys) {
    if (keys.mode == MapMode::raw) {
        const double value = std::round(shade * kWhite);
        return value > 100.0 ? CellState::unknown : state_of_percent(value);
    }
    const bool is_trinary = keys.mode == MapMode::trinary;
    if (is_trinary && keys.unknown_grey && std::lround(shade * kWhite) == *keys.unknown_grey) {
        return CellState::unknown;
    }
    const double occupancy = keys.negate ? shade : 1.0 - shade;
    if (occupancy >= keys.occupied_thresh) return CellState::occupied;
    if (occupancy <= keys.free_thresh) return CellState::free;
    if (is_trinary) return CellState::unknown;
    return state_of_percent(std::round((occupancy - keys.free_thresh) /
                                       (keys.occupied_thresh - keys.free_thresh) * 100.0));
}

PixelStates::PixelStates(const ImageHeader& header, const MapKeys& keys, Ground ground)
    : num_channels_(static_cast<std::size_t>(header.channels)),
      num_colors_(header.channels < 3 ? 1 : 3),
      opaque_(static_cast<std::uint16_t>(header.max_value)),
      uses_alpha_(header.channels % 2 == 0 && keys.mode != MapMode::raw),
      ground_(ground) {
    const std::size_t brightest = num_colors_ * static_cast<std::size_t>(header.max_value);
    ground_sum_ = keys.negate ? 0 : brightest;
    for (std::size_t sum = 0; sum <= brightest; ++sum) {
        states_.push_back(
            state_of_shade(static_cast<double>(sum) / static_cast<double>(brightest), keys));
    }
    counts_.resize(states_.size());
}

std::size_t PixelStates::color_sum(const std::uint16_t* pixel) const {
    return num_colors_ == 1 ? pixel[0] : std::size_t{pixel[0]} + pixel[1] + pixel[2];
}

CellState PixelStates::count_opaque(std::size_t sum) {
    ++counts_[sum];
    return states_[sum];
}

CellState PixelStates::count_not_opaque(std::size_t sum, std::uint16_t alpha) {
    if (ground_ == Ground::floor) {
        const std::size_t ground = ground_sum_ * static_cast<std::size_t>(opaque_ - alpha);
        return count_opaque((sum * alpha + ground) / opaque_);
    }
    ++num_not_opaque_;
    if (alpha == 0) ++num_transparent_;
    return CellState::unknown;
}

void PixelStates::convert(std::span<const std::uint16_t> samples, CellState* cells) {
    for (std::size_t i = 0; i < samples.size(); i += num_channels_) {
        const std::uint16_t* const pixel = samples.data() + i;
        const std::size_t sum = color_sum(pixel);
        const std::uint16_t alpha = uses_alpha_ ? pixel[num_channels_ - 1] : opaque_;
        *cells++ = alpha == opaque_ ? count_opaque(sum) : count_not_opaque(sum, alpha);
    }
}

GreyTally PixelStates::tally() const {
    GreyTally tally;
    tally.num_not_opaque = num_not_opaque_;
    tally.num_transparent = num_transparent_;
    const std::size_t brightest = counts_.size() - 1;
    for (std::size_t sum = 0; sum <= brightest; ++sum) {
        tally.counts[(sum * kWhite + brightest / 2) / brightest] += counts_[sum];
    }
    return tally;
}

}  // namespace quadcut::io
