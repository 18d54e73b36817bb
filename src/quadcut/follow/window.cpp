// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/window.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/follow/split_line.hpp"
#include "quadcut/rooms/narrowing.hpp"

namespace quadcut {
namespace {

/// Rooms with cells this near to a change are cut again, as far as this from it.
constexpr double kTouchedM = 1.0;
constexpr double kFarM = 20.0;

/// Of all lines, by y and x.
std::set<std::pair<std::int32_t, std::int32_t>> split_cells(const FollowedMap& followed,
                                                            const Box& box) {
    std::set<std::pair<std::int32_t, std::int32_t>> cells;
    for (const SplitLine& line : followed.split_lines) {
        for (const Cell cell : cells_of(line)) {
            if (box.contains(cell)) cells.emplace(cell.y, cell.x);
        }
    }
    return cells;
}

}  // namespace

Window read_window(const FollowedMap& followed, const Box& box, const Box& decided) {
    Window window{
        Raster<CellState>(box, CellState::unknown), Raster<std::uint32_t>(box), decided, {}};
    for (const auto& [id, room] : followed.rooms) {
        if (room.is_locked) window.locked.insert(id);
    }
    for (std::size_t i = 0; i < window.states.values.size(); ++i) {
        const Cell cell = window.states.cell(i);
        window.rooms.values[i] = followed.cells.room(cell);
        const bool is_wall =
            !window.locked.empty() && window.locked.count(window.rooms.values[i]) != 0;
        window.states.values[i] = is_wall ? CellState::occupied : followed.map.state(cell);
    }
    for (const auto& [y, x] : split_cells(followed, box)) {
        window.states.at({x, y}) = CellState::occupied;
    }
    return window;
}

Box cells_to_decide(const FollowedMap& followed, const Box& changed) {
    const Box far = changed.grown(followed.in_cells(kFarM));
    std::set<std::uint32_t> rooms;
    for_each_cell(changed.grown(followed.in_cells(kTouchedM)),
                  [&](Cell cell) { rooms.insert(followed.cells.room(cell)); });
    Box decided = changed.grown(followed.in_cells(kNarrowingReachM));
    for (const std::uint32_t id : rooms) {
        if (id == 0) continue;
        const FollowedRoom& room = followed.rooms.at(id);
        if (!room.is_locked) decided.include(room.box);
    }
    return decided.intersected(far);
}

void drop_uncrossed(const std::vector<Cell>& way, WindowCut& cut) {
    if (way.empty()) return;
    std::vector<bool> is_crossed(cut.num_regions + std::size_t{1}, false);
    for (const KeptPart& part : cut.kept) is_crossed[part.region] = true;
    for (const Cell cell : way) {
        if (!cut.regions.contains(cell)) continue;
        const std::uint32_t region = cut.regions.at(cell);
        if (region != kNotCut) is_crossed[region] = true;
    }
    std::vector<std::uint32_t> numbers(is_crossed.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t region = 1; region < numbers.size(); ++region) {
        if (!is_crossed[region]) continue;
        numbers[region] = ++count;
        if (!cut.peak_m.empty()) cut.peak_m[count] = cut.peak_m[region];
    }
    for (std::uint32_t& region : cut.regions.values) {
        if (region != kNotCut) region = numbers[region];
    }
    for (KeptPart& part : cut.kept) part.region = numbers[part.region];
    cut.num_regions = count;
}

void fill_split_lines(const FollowedMap& followed, WindowCut& cut) {
    const auto cells = split_cells(followed, cut.regions.box());
    bool is_any = true;
    while (is_any) {
        is_any = false;
        for (const auto& [y, x] : cells) {
            if (followed.map.state({x, y}) != CellState::free) continue;
            if (cut.regions.at({x, y}) != 0) continue;
            for (const Cell step : kStepsBeside) {
                const Cell beside{x + step.x, y + step.y};
                if (!cut.regions.contains(beside)) continue;
                const std::uint32_t region = cut.regions.at(beside);
                if (region == 0 || region == kNotCut) continue;
                cut.regions.at({x, y}) = region;
                is_any = true;
                break;
            }
        }
    }
}

}  // namespace quadcut
