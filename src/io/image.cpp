// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/image.hpp"

#include <algorithm>
#include <array>

#include "io/file.hpp"
#include "io/file_kind.hpp"
#include "io/inflate.hpp"
#include "io/input.hpp"
#include "io/jpeg.hpp"
#include "io/picture.hpp"
#include "io/tiff.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {

namespace {

struct ImageFormat {
    bool (*begins)(std::string_view bytes);
    ParsedImage (*parse)(std::string_view bytes, const std::string& name, const ImageRowSink& sink);
};

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }

bool is_pgm(std::string_view bytes) { return bytes.starts_with("P2") || bytes.starts_with("P5"); }

constexpr std::array kFormats{ImageFormat{is_png, parse_png}, ImageFormat{is_pgm, parse_pgm},
                              ImageFormat{is_tiff, parse_tiff}, ImageFormat{is_jpeg, parse_jpeg},
                              ImageFormat{is_picture, parse_picture}};

const ImageFormat* find_format(std::string_view bytes) {
    const auto found =
        std::find_if(kFormats.begin(), kFormats.end(),
                     [bytes](const ImageFormat& format) { return format.begins(bytes); });
    return found == kFormats.end() ? nullptr : &*found;
}

/// So much may be in gzip: a few bytes of it can stand for any number. What is packed again has no
/// need to be large.
std::uint64_t max_unpacked_bytes(std::string_view bytes, const std::string& name) {
    constexpr std::uint64_t kMaxPackedAgain = std::uint64_t{1} << 28U;
    const std::string beginning = unpack_beginning(bytes);
    if (!is_pgm(beginning)) return kMaxPackedAgain;
    return std::min(max_pgm_bytes(beginning, name), kMaxFileBytes);
}

void require_image(std::string_view bytes, const std::string& name) {
    if (is_image(bytes)) return;
    throw InputError(describe_refusal(bytes, name, "an image (PNG, PGM, TIFF, BMP, JPEG, GIF)"));
}

}  // namespace

bool is_image(std::string_view bytes) {
    if (is_gzip(bytes)) return find_format(unpack_beginning(bytes)) != nullptr;
    return find_format(bytes) != nullptr;
}

ParsedImage parse_image(std::string_view bytes, const std::string& name, const ImageRowSink& sink) {
    require_image(bytes, name);
    if (!is_gzip(bytes)) return find_format(bytes)->parse(bytes, name, sink);
    const std::string unpacked = unpack_gzip(bytes, name, max_unpacked_bytes(bytes, name));
    return find_format(unpacked)->parse(unpacked, name, sink);
}

InputFile read_image_input(const std::filesystem::path& path) {
    return read_input(
        path, [](const InputFile& beginning) { require_image(beginning.bytes, beginning.name); });
}

}  // namespace quadcut::io
