// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <zlib.h>

#include "io/grey_evidence.hpp"
#include "io/image.hpp"
#include "io/map_server.hpp"
#include "io/map_yaml.hpp"
#include "io/no_rooms.hpp"
#include "quadcut/base/error.hpp"

// The bytes are an image, or a map_server YAML, or a YAML and (after a NUL byte) its image.

namespace {

void read_map_bytes(std::string_view bytes) {
    namespace io = quadcut::io;
    const std::size_t border = bytes.find('\0');
    const bool is_image = io::is_image(bytes);
    const io::MapKeys keys =
        is_image ? io::bare_image_keys() : io::parse_map_yaml(bytes.substr(0, border), "fuzz.yaml");
    if (!is_image && border == std::string_view::npos) return;
    if (is_image) {
        const io::MapFile file = io::parse_map({"", "fuzz.png", "", std::string(bytes)});
        (void)io::parse_map_as_before({"", "fuzz.png", "", std::string(bytes)}, file.keys);
    }
    const std::string_view image = is_image ? bytes : bytes.substr(border + 1);
    const io::ParsedMap parsed = io::parse_map_image(image, "fuzz.png", keys);
    const quadcut::GridMap& map = parsed.map;
    // What a reader hands on keeps its promises.
    const auto reading = io::find_grey_reading(parsed.greys, keys, io::NegateSource::file);
    if (reading && reading->keys.free_thresh > reading->keys.occupied_thresh) __builtin_trap();
    (void)io::why_no_rooms(parsed.greys, keys);
    const auto cells =
        static_cast<std::size_t>(map.states.width) * static_cast<std::size_t>(map.states.height);
    if (cells == 0 || map.states.values.size() != cells) __builtin_trap();
}

/// Makes the check sums of a PNG's chunks right again, without which a changed one ends at once.
void mend_check_sums(std::span<std::uint8_t> png) {
    constexpr std::size_t kSignature = 8;
    constexpr std::size_t kAround = 12;  // Length, name, check sum.
    std::size_t first = kSignature;
    while (first + kAround <= png.size()) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8U | png[first + i];
        if (length > png.size() - first - kAround) return;
        const std::uint8_t* const name = &png[first + 4];
        const auto sum = static_cast<std::uint32_t>(crc32(0, name, static_cast<uInt>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i) {
            png[first + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        }
        first += length + kAround;
    }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned) {
    const std::size_t new_size = LLVMFuzzerMutate(data, size, max_size);
    const std::span<std::uint8_t> bytes(data, new_size);
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    const auto found = std::search(
        bytes.begin(), bytes.end(), kSignature.begin(), kSignature.end(),
        [](std::uint8_t byte, char c) { return byte == static_cast<unsigned char>(c); });
    mend_check_sums(bytes.subspan(static_cast<std::size_t>(found - bytes.begin())));
    return new_size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        read_map_bytes({reinterpret_cast<const char*>(data), size});
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
