// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/image.hpp"

#include <algorithm>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }

bool is_pgm(std::string_view bytes) { return bytes.starts_with("P2") || bytes.starts_with("P5"); }

ImageHeader parse_image(std::string_view bytes, const std::string& name, const ImageRowSink& sink) {
    if (is_png(bytes)) return parse_png(bytes, name, sink);
    if (is_pgm(bytes)) return parse_pgm(bytes, name, sink);
    throw InputError(name +
                     (bytes.empty() ? ": the file is empty" : ": not an image that is read") +
                     ", expected a PNG or a PGM (P2, P5)");
}

Image read_image(const std::filesystem::path& path) {
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
    image.header = parse_image(read_file(path), display_name(path), keep_row);
    return image;
}

void write_png(const std::filesystem::path& path, const ImageHeader& header,
               const ImageRowSource& source) {
    write_file_atomically(path, encode_png(header, source));
}

void write_png(const std::filesystem::path& path, const Image& image) {
    const auto copy_row = [&image](std::int32_t y, std::span<std::uint16_t> samples) {
        const std::span<const std::uint16_t> row = image.row(y);
        std::copy(row.begin(), row.end(), samples.begin());
    };
    write_png(path, image.header, copy_row);
}

void write_pgm(const std::filesystem::path& path, const ImageHeader& header,
               const ImageRowSource& source) {
    write_file_atomically(path, encode_pgm(header, source));
}

}  // namespace quadcut::io
