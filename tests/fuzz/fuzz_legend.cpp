// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "io/previous_result.hpp"
#include "io/stored_result.hpp"
#include "quadcut/base/error.hpp"

// The bytes are the rooms.yaml of an earlier result, and after a NUL byte its rooms.png or its
// rooms.geojson.

namespace {

void require_promises(const quadcut::io::RoomsLegend& legend) {
    if (legend.values.size() != legend.rooms.size()) __builtin_trap();
    std::vector<bool> is_taken(legend.next_id, false);
    for (const quadcut::Room& room : legend.rooms) {
        const std::size_t id = quadcut::index(room.id);
        if (id == 0 || id >= legend.next_id || is_taken[id]) __builtin_trap();
        is_taken[id] = true;
    }
}

void read_result(std::string_view bytes) {
    namespace io = quadcut::io;
    const std::size_t border = bytes.find('\0');
    io::RoomsLegend legend = io::parse_rooms_yaml(bytes.substr(0, border), "fuzz.yaml");
    // What a reader hands on keeps its promises.
    require_promises(legend);
    if (border == std::string_view::npos) return;
    const std::string_view beside = bytes.substr(border + 1);
    if (beside.starts_with('{')) {
        (void)io::parse_doors(beside, "fuzz.geojson", legend.rooms);
        return;
    }
    const std::size_t num_rooms = legend.rooms.size();
    const io::PreviousResult result =
        io::parse_label_png(beside, "fuzz.png", std::move(legend), "fuzz.yaml");
    for (const std::uint16_t label : result.labels.values) {
        if (label > num_rooms) __builtin_trap();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        read_result({reinterpret_cast<const char*>(data), size});
    } catch (const quadcut::InputError&) {
    }
    return 0;
}
