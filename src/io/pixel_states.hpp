// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/image.hpp"
#include "io/map_yaml.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

inline constexpr int kWhite = 255;

/// How many pixels have which brightness, on a scale of 0 .. 255 whatever the image's own.
struct GreyTally {
    std::array<std::uint64_t, kWhite + 1> counts{};
    /// Pixels that are not opaque and have no grey here, and of these the fully transparent.
    std::uint64_t num_not_opaque = 0;
    std::uint64_t num_transparent = 0;

    /// Pixels of the greys first .. last.
    [[nodiscard]] std::uint64_t count(int first = 0, int last = kWhite) const;
};

/// What pixels that are not opaque are: unknown, as map_server has it, or drawn on the colour of
/// the floor, and counted so.
enum class Ground : std::uint8_t { unknown, floor };

/// The state of a pixel whose brightness is `shade` of 0 .. 1. See read_map() for the rules.
[[nodiscard]] CellState state_of_shade(double shade, const MapKeys& keys);

/// Turns the rows of one image into states. The sum of a pixel's colours is its index into a table
/// of states.
class PixelStates {
public:
    PixelStates(const ImageHeader& header, const MapKeys& keys, Ground ground);

    /// Writes a state a pixel to `cells`.
    void convert(std::span<const std::uint16_t> samples, CellState* cells);
    /// Of all rows so far.
    [[nodiscard]] GreyTally tally() const;

private:
    [[nodiscard]] std::size_t color_sum(const std::uint16_t* pixel) const;
    [[nodiscard]] CellState count_opaque(std::size_t sum);
    [[nodiscard]] CellState count_not_opaque(std::size_t sum, std::uint16_t alpha);

    std::size_t num_channels_;
    std::size_t num_colors_;
    std::uint16_t opaque_;
    bool uses_alpha_;
    Ground ground_;
    std::size_t ground_sum_;
    std::vector<CellState> states_;
    std::vector<std::uint64_t> counts_;
    std::uint64_t num_not_opaque_ = 0;
    std::uint64_t num_transparent_ = 0;
};

}  // namespace quadcut::io
