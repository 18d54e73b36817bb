// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "io/file.hpp"
#include "io/image.hpp"

// Whole images, which only tests hold and write.
namespace quadcut::io {

/// A whole image in memory, two bytes a sample, row 0 at the top.
struct Image {
    ImageHeader header;
    std::vector<std::uint16_t> samples;

    [[nodiscard]] std::span<const std::uint16_t> row(std::int32_t y) const {
        return {samples.data() + static_cast<std::size_t>(y) * header.row_samples(),
                header.row_samples()};
    }
};

inline Image read_image(const std::filesystem::path& path) {
    Image image;
    const auto keep_row = [&image](const ImageHeader& header, std::int32_t y,
                                   std::span<const std::uint16_t> samples) {
        if (y == 0) {
            image.samples.resize(header.row_samples() * static_cast<std::size_t>(header.height));
        }
        std::copy(samples.begin(), samples.end(),
                  image.samples.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) *
                                                                      header.row_samples()));
    };
    const InputFile file = read_image_input(path);
    image.header = parse_image(file.bytes, file.name, keep_row).header;
    return image;
}

inline void write_png(const std::filesystem::path& path, const ImageHeader& header,
                      const ImageRowSource& source) {
    write_file_atomically(path, encode_png(header, source));
}

inline void write_png(const std::filesystem::path& path, const Image& image) {
    const auto copy_row = [&image](std::int32_t y, std::span<std::uint16_t> samples) {
        const std::span<const std::uint16_t> row = image.row(y);
        std::copy(row.begin(), row.end(), samples.begin());
    };
    write_png(path, image.header, copy_row);
}

inline void write_pgm(const std::filesystem::path& path, const ImageHeader& header,
                      const ImageRowSource& source) {
    write_file_atomically(path, encode_pgm(header, source));
}

}  // namespace quadcut::io
