// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/map_file.hpp"
#include "quadcut/base/error.hpp"

// The bytes are a map in its binary form without the checksum, so that the fuzzer gets past it.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::byte> bytes(size + 8);
    std::transform(data, data + size, bytes.begin(),
                   [](std::uint8_t byte) { return static_cast<std::byte>(byte); });
    std::uint64_t hash = 0xCBF2'9CE4'8422'2325U;
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ data[i]) * 0x0000'0100'0000'01B3U;
    for (std::size_t i = 0; i < 8; ++i) {
        bytes[size + i] = static_cast<std::byte>(hash >> (8 * i) & 0xFF);
    }
    try {
        const quadcut::OccupancyMap map = quadcut::io::decode_map(bytes, "fuzz.map");
        // What is read is read exactly.
        if (quadcut::io::encode_map(map) != bytes) __builtin_trap();
        if (map.leaves().size() != map.num_leaves()) __builtin_trap();
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
