// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/previous_result.hpp"
#include "quadcut/base/error.hpp"

// The bytes are the rooms.yaml of an earlier result.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const quadcut::io::RoomsLegend legend =
            quadcut::io::parse_rooms_yaml({reinterpret_cast<const char*>(data), size}, "fuzz.yaml");
        // What a reader hands on keeps its promises.
        if (legend.values.size() != legend.rooms.size()) __builtin_trap();
        std::vector<bool> is_taken(legend.next_id, false);
        for (const quadcut::Room& room : legend.rooms) {
            const std::size_t id = quadcut::index(room.id);
            if (id == 0 || id >= legend.next_id || is_taken[id]) __builtin_trap();
            is_taken[id] = true;
        }
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
