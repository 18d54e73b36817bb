// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/file.hpp"
#include "io/input.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut::io {

/// The most pixels an image may have.
inline constexpr std::uint64_t kMaxImagePixels = std::uint64_t{1} << 30U;

/// The form of an image. Channels: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA. A sample lies in
/// 0 .. max_value; 255 and 65535 are the depths of PNG, PGM has any from 1 to 65535.
struct ImageHeader {
    std::int32_t width = 0;
    std::int32_t height = 0;
    int channels = 1;
    int max_value = 255;

    [[nodiscard]] std::size_t row_samples() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    }
    friend bool operator==(const ImageHeader&, const ImageHeader&) = default;
};

/// Takes the rows of an image from the top down.
using ImageRowSink = std::function<void(const ImageHeader& header, std::int32_t y,
                                        std::span<const std::uint16_t> samples)>;
/// Fills the rows of an image from the top down.
using ImageRowSource = std::function<void(std::int32_t y, std::span<std::uint16_t> samples)>;

/// What was found out about an image while its rows were handed on.
struct ParsedImage {
    ImageHeader header;
    std::vector<std::string> warnings;  ///< without the name of the file
};

/// Whether the bytes begin like an image of a kind that parse_image() reads.
[[nodiscard]] bool is_image(std::string_view bytes);

/// Decodes an image row by row, its kind told by content:
/// PNG (any colour type and depth; palettes and 1, 2 and 4 bits are expanded to 8),
/// PGM (P2, P5, 8 and 16 bits), TIFF (as parse_tiff() says), BMP, JPEG, GIF (the first picture),
/// and any of these in gzip. A PNG or TIFF that is not interlaced or tiled needs memory for one row
/// only, a BMP, JPEG or GIF for all. Sizes are read from headers, and refused, before memory is
/// taken for them. Bytes after the image are a warning. Throws InputError when the bytes are of no
/// such kind, are damaged or end early, or when the image has more than kMaxImagePixels; `name`
/// stands in the messages.
ParsedImage parse_image(std::string_view bytes, const std::string& name, const ImageRowSink& sink);
ParsedImage parse_png(std::string_view bytes, const std::string& name, const ImageRowSink& sink);
ParsedImage parse_pgm(std::string_view bytes, const std::string& name, const ImageRowSink& sink);

/// How long a PGM that begins so can be, comments and surplus bytes included. Errors as parse_pgm.
[[nodiscard]] std::uint64_t max_pgm_bytes(std::string_view beginning, const std::string& name);

/// Reads the bytes of an image, which may come through a pipe or standard input ("-"). Throws
/// InputError as read_input() does, and when its first bytes are of no image.
[[nodiscard]] InputFile read_image_input(const std::filesystem::path& path);

/// Rows first .. last - 1 of an image as a PNG has them: a byte a sample, or two, the high one
/// first.
struct ImageBand {
    std::int32_t first = 0;
    std::int32_t last = 0;
    std::uint8_t* samples = nullptr;
    /// From one row to the next.
    std::size_t stride = 0;

    [[nodiscard]] std::uint8_t* row(std::int32_t y) const {
        return samples + static_cast<std::size_t>(y - first) * stride;
    }
};
using ImageBandSource = std::function<void(const ImageBand& band)>;

/// Encodes a PNG that says who wrote it (io/authorship.hpp), in bands of 64 rows: with several
/// threads, the source is called from all of them, and the bands come in any order. The same bytes
/// on any number of threads. About 2 ns a sample. @pre max_value is 255 or 65535, width and height
/// are positive.
[[nodiscard]] std::string encode_png(const ImageHeader& header, const ImageRowSource& source,
                                     const Executor& executor = {});
/// The same where rows are made several at a time, into bytes that are 0.
[[nodiscard]] std::string encode_png_bands(const ImageHeader& header, const ImageBandSource& source,
                                           const Executor& executor = {});
/// Encodes a binary PGM (P5) that says who wrote it, 8 or 16 bits by max_value. @pre one channel.
[[nodiscard]] std::string encode_pgm(const ImageHeader& header, const ImageRowSource& source);

}  // namespace quadcut::io
