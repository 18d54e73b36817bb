// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/rooms_in_box.hpp"

#include <map>
#include <set>
#include <utility>

namespace quadcut {

RoomsInBox rooms_in_box(const FollowedMap& followed, const Box& box) {
    Raster<std::uint32_t> labels({0, 0}, box.width(), box.height());
    std::set<std::uint32_t> rooms;
    std::uint32_t last = 0;
    std::size_t i = 0;
    for_each_cell(box, [&](Cell cell) {
        const std::uint32_t room = followed.cells.room(cell);
        // Neighbouring cells mostly have the same.
        if (room != last && room != 0) rooms.insert(room);
        labels.values[i++] = last = room;
    });
    RoomsInBox found{std::move(labels),
                     Raster<CellState>({0, 0}, box.width(), box.height()),
                     Raster<std::uint8_t>({0, 0}, box.width(), box.height()),
                     {rooms.begin(), rooms.end()},
                     std::vector<std::size_t>(rooms.size(), 0)};
    std::map<std::uint32_t, std::uint32_t> labels_of;
    for (const std::uint32_t room : found.rooms) {
        labels_of.emplace(room, static_cast<std::uint32_t>(labels_of.size() + 1));
    }
    last = 0;
    std::uint32_t label = 0;
    i = 0;
    for_each_cell(box, [&](Cell cell) {
        const std::size_t at = i++;
        const std::uint32_t room = found.labels.values[at];
        const CellState state = found.states.values[at] = followed.map.state(cell);
        if (room == 0) return;
        if (room != last) label = labels_of.at(last = room);
        ++found.num_cells[label - 1];
        const bool is_free = state == CellState::free;
        const bool is_shut = !is_free && followed.rooms.at(room).is_locked;
        found.labels.values[at] = is_shut ? 0 : label;
        found.free.values[at] = is_free ? 1 : 0;
    });
    return found;
}

}  // namespace quadcut
