// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/image.hpp"

namespace quadcut::io {

/// A BMP, a JPEG or a GIF may be held as a whole while it is decoded, and has so many pixels at
/// most.
inline constexpr std::uint64_t kMaxPicturePixels = std::uint64_t{1} << 28U;

/// What a header says of an image.
struct PromisedImage {
    std::string_view kind;  ///< "PNG"
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint64_t pixel_bits = 0;
};

/// Throws InputError that begins with `place` unless there is a pixel, and `max_pixels` at most.
void check_size(const PromisedImage& image, const std::string& place,
                std::uint64_t max_pixels = kMaxImagePixels);

/// Throws InputError when `num_bytes`, of which each stands for `max_ratio` at most, cannot hold
/// what was promised: before memory is taken for it.
void check_fits(const PromisedImage& image, const std::string& name, std::uint64_t num_bytes,
                std::uint64_t max_ratio);

/// What to say of bytes after an image; nothing when there are none.
[[nodiscard]] std::vector<std::string> warnings_of_surplus(std::size_t num_bytes);

}  // namespace quadcut::io
