// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "quadcut/map/raster.hpp"

namespace quadcut::io {

/// Regions of an image, as a file shows them: row 0 is the TOP one. 0 = no region, the others are
/// numbered 1 .. num_regions without gaps, in order of their values in the file.
struct LabelImage {
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::uint32_t num_regions = 0;
    std::vector<std::uint32_t> values;
    std::vector<std::string> warnings = {};  ///< with the name of the file
};

/// Regions of this many pixels or fewer are not counted as regions when segmentations are compared.
inline constexpr std::size_t kIgnoredRegionPixels = 100;

/// Numbers the values of an image densely: 0 stays 0, values on at most `ignored_pixels` pixels
/// become 0, the others 1, 2, ... ascending. O(pixels log values).
/// @pre values.size() == width * height.
[[nodiscard]] LabelImage number_regions(std::int32_t width, std::int32_t height,
                                        const std::vector<std::uint32_t>& values,
                                        std::size_t ignored_pixels = kIgnoredRegionPixels);

/// Reads regions from an image: each grey value (8 or 16 bits), or each colour, except black, is
/// one. Regions of at most kIgnoredRegionPixels are left out. Errors as read_image_input,
/// parse_image.
[[nodiscard]] LabelImage read_label_image(const std::filesystem::path& path);

/// Which cells of a map image are free, row 0 at the top.
struct FreeMask {
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::vector<std::uint8_t> is_free;
    std::vector<std::string> warnings = {};  ///< with the name of the file
};

/// map_server's "unknown": what is brighter is free, be it only likely.
inline constexpr std::uint32_t kUnknownGrey = 205;
/// What is brighter is free for certain, also where greys are probabilities.
inline constexpr std::uint32_t kSurelyFreeGrey = 230;

/// A cell is free where the image is brighter than `darkest_grey` of 255; colours by their luma.
/// Errors as read_image_input and parse_image.
[[nodiscard]] FreeMask read_free_mask(const std::filesystem::path& path,
                                      std::uint32_t darkest_grey = kUnknownGrey);

/// A label raster as a 16-bit grey PNG, turned upright: its lowest row is the last one of the
/// image.
/// @pre the raster is not empty.
[[nodiscard]] std::string encode_label_png(const Raster<std::uint16_t>& labels);

}  // namespace quadcut::io
