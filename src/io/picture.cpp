// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/picture.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>

// Kinds that are not asked for are not there to be attacked.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_GIF
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>

#include "io/image_checks.hpp"
#include "io/picture_frame.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr int kMaxByte = 255;

struct PictureFormat {
    const char* kind;
    bool (*begins)(std::string_view bytes);
    std::size_t (*end)(std::string_view bytes, const std::string& name);
};

constexpr std::array kFormats{PictureFormat{"BMP", is_bmp, end_of_bmp},
                              PictureFormat{"GIF", is_gif, end_of_gif}};

const PictureFormat* find_format(std::string_view bytes) {
    const auto found =
        std::find_if(kFormats.begin(), kFormats.end(),
                     [bytes](const PictureFormat& format) { return format.begins(bytes); });
    return found == kFormats.end() ? nullptr : &*found;
}

/// What the decoder is given: its lengths are of type int.
struct Encoded {
    const stbi_uc* bytes;
    int size;
};

Encoded encoded(std::string_view bytes, const std::string& name) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw InputError(name + ": larger than the pictures that are read");
    }
    return {reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size())};
}

[[noreturn]] void fail(const std::string& name, const PictureFormat& format) {
    const char* const reason = stbi_failure_reason();
    throw InputError(name + ": damaged " + format.kind + ", or of a kind that is not read: " +
                     (reason == nullptr ? "no reason given" : reason) +
                     "; any picture program saves it as a PNG");
}

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

bool is_picture(std::string_view bytes) { return find_format(bytes) != nullptr; }

ParsedImage parse_picture(std::string_view bytes, const std::string& name,
                          const ImageRowSink& sink) {
    const PictureFormat* const format = find_format(bytes);
    if (format == nullptr) throw InputError(name + ": expected a BMP or a GIF");
    const Encoded source = encoded(bytes, name);
    const std::size_t end = format->end(bytes, name);

    ImageHeader header{0, 0, 0, kMaxByte};
    const std::unique_ptr<stbi_uc, FreePixels> pixels(stbi_load_from_memory(
        source.bytes, source.size, &header.width, &header.height, &header.channels, 0));
    if (!pixels) fail(name, *format);
    std::vector<std::uint16_t> row(header.row_samples());
    for (std::int32_t y = 0; y < header.height; ++y) {
        std::copy_n(pixels.get() + static_cast<std::size_t>(y) * row.size(), row.size(),
                    row.begin());
        sink(header, y, row);
    }
    return {header, warnings_of_surplus(bytes.size() - end)};
}

}  // namespace quadcut::io
