// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/floor_cells.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

#include "draw/part_tallies.hpp"
#include "draw/thick_parts.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/enclosed_patches.hpp"

namespace quadcut::draw {
namespace {

constexpr double kMarginMetres = 1.0;
constexpr double kMaxFurnitureMetres = 4.0;
constexpr double kMaxWallMetres = 0.5;
/// How far labels may reach into a wall, or across its near face.
constexpr double kRimMetres = 0.15;
/// Bounds memory, whatever the resolution says.
constexpr std::int32_t kMaxWallCells = 256;

/// How many cells fit into a length.
std::int32_t to_cells(double metres, double resolution_m) {
    constexpr double kMost = 1e6;
    constexpr double kRounding = 1e-6;
    return static_cast<std::int32_t>(std::min(metres / resolution_m + kRounding, kMost));
}

/// The cells for which `wanted(offset)` holds.
template <typename Wanted>
Box bounds_where(const Raster<CellState>& states, const Wanted& wanted) {
    Box bounds;
    for (std::int32_t y = 0; y < states.height; ++y) {
        const std::size_t row =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(states.width);
        const auto at = [&](std::int32_t x) { return wanted(row + static_cast<std::size_t>(x)); };
        std::int32_t first = 0;
        while (first < states.width && !at(first)) ++first;
        if (first == states.width) continue;
        std::int32_t last = states.width - 1;
        while (!at(last)) --last;
        bounds.include({{first, y}, {last, y}});
    }
    return bounds;
}

/// The part of the map to draw, as places within its raster.
Box find_frame(const GridMap& map, const Raster<std::uint16_t>& labels) {
    const Raster<CellState>& states = map.states;
    Box frame = bounds_where(states, [&](std::size_t i) { return labels.values[i] != 0; });
    if (frame.is_empty()) {
        frame = bounds_where(states,
                             [&](std::size_t i) { return states.values[i] != CellState::unknown; });
    }
    const Box all{{0, 0}, {states.width - 1, states.height - 1}};
    if (frame.is_empty()) return all;
    return frame.grown(to_cells(kMarginMetres, map.resolution_m)).intersected(all);
}

/// Calls `body(first, last)` for a few rows at a time.
void for_rows(const Executor& executor, std::int32_t height,
              const std::function<void(std::size_t first, std::size_t last)>& body) {
    constexpr std::size_t kRows = 32;
    parallel_for(executor, static_cast<std::size_t>(height), kRows, body);
}

/// Calls `body(first, last)` for some thousand cells at a time.
void for_cells(const Executor& executor, std::size_t num_cells,
               const std::function<void(std::size_t first, std::size_t last)>& body) {
    constexpr std::size_t kCells = std::size_t{1} << 16U;
    parallel_for(executor, num_cells, kCells, body);
}

FloorCells classify(const GridMap& map, const Raster<std::uint16_t>& labels,
                    const Executor& executor) {
    const Box frame = find_frame(map, labels);
    const std::int32_t width = frame.width();
    const std::int32_t height = frame.height();
    const Cell origin{map.states.origin.x + frame.low.x, map.states.origin.y + frame.low.y};
    FloorCells cells{{origin, width, height}, {origin, width, height}};
    constexpr std::uint16_t kLastRoom = kFirstNonRoom - 1;
    constexpr std::array<std::uint16_t, 3> kGroundOf = {0, kLooseFree, kWall};
    // A room's label covers what stands in it, too: an obstacle is still to be seen.
    constexpr std::array<std::uint8_t, 3> kFurnitureOf = {kFurnitureInside, 0, kFurniture};
    static_assert(static_cast<int>(CellState::unknown) == 0 &&
                  static_cast<int>(CellState::free) == 1 &&
                  static_cast<int>(CellState::occupied) == 2);
    for_rows(executor, height, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
            const std::size_t from =
                map.states.offset({origin.x, origin.y + static_cast<std::int32_t>(y)});
            const CellState* const states = map.states.values.data() + from;
            const std::uint16_t* const label = labels.values.data() + from;
            std::uint16_t* const ground =
                cells.ground.values.data() + y * static_cast<std::size_t>(width);
            std::uint8_t* const furniture =
                cells.furniture.values.data() + y * static_cast<std::size_t>(width);
            for (std::int32_t x = 0; x < width; ++x) {
                const auto state = static_cast<std::size_t>(states[x]);
                ground[x] = label[x] != 0 ? std::min(label[x], kLastRoom) : kGroundOf[state];
                furniture[x] = label[x] != 0 ? kFurnitureOf[state] : std::uint8_t{0};
            }
        }
    });
    return cells;
}

/// 1 for each cell of this value.
Raster<std::uint8_t> mask_of(const Raster<std::uint16_t>& ground, std::uint16_t value,
                             const Executor& executor) {
    Raster<std::uint8_t> mask(ground.origin, ground.width, ground.height);
    for_cells(executor, mask.values.size(), [&](std::size_t first, std::size_t last) {
        std::transform(ground.values.data() + first, ground.values.data() + last,
                       mask.values.data() + first,
                       [value](std::uint16_t cell) { return std::uint8_t{cell == value}; });
    });
    return mask;
}

bool is_any_set(const Raster<std::uint8_t>& mask) {
    return std::memchr(mask.values.data(), 1, mask.values.size()) != nullptr;
}

ConnectedParts parts_of(const Raster<std::uint8_t>& mask, const Executor& executor) {
    return connected_parts(
        mask, [&](std::size_t i) { return mask.values[i]; }, Connectivity::four, executor);
}

/// The cells of rooms that have only their own room around them, `margin_cells` far.
Raster<std::uint8_t> find_inner_cells(const Raster<std::uint16_t>& ground,
                                      std::int32_t margin_cells, const Executor& executor) {
    Raster<std::uint8_t> mask(ground.origin, ground.width, ground.height);
    const auto width = static_cast<std::size_t>(ground.width);
    for_rows(executor, ground.height, [&](std::size_t first, std::size_t last) {
        first = std::max<std::size_t>(first, 1);
        last = std::min(last, static_cast<std::size_t>(ground.height) - 1);
        for (std::size_t y = first; y < last; ++y) {
            const std::uint16_t* const row = ground.values.data() + y * width;
            std::uint8_t* const to = mask.values.data() + y * width;
            for (std::size_t x = 1; x + 1 < width; ++x) {
                const std::uint16_t room = row[x];
                // Without branches, eight cells at a time.
                const unsigned differs = static_cast<unsigned>(row[x - 1] ^ room) |
                                         static_cast<unsigned>(row[x + 1] ^ room) |
                                         static_cast<unsigned>(row[x + width] ^ room) |
                                         static_cast<unsigned>(*(row + x - width) ^ room);
                to[x] = static_cast<std::uint8_t>((differs == 0) & is_room(room));
            }
        }
    });
    return find_deep_parts(mask, margin_cells, executor);
}

/// What the rim cuts off from the inside of a room is taken from it, too.
void take_cut_off_parts(Raster<std::uint16_t>& ground, const Raster<std::uint8_t>& inner,
                        const Executor& executor) {
    const ConnectedParts parts = connected_parts(
        ground, [&](std::size_t i) { return is_room(ground.values[i]) ? ground.values[i] : 0; },
        Connectivity::four, executor);
    std::vector<bool> part_has_inner(parts.count + std::size_t{1});
    std::vector<bool> room_has_inner(kFirstNonRoom);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        if (part_has_inner[run.part]) return;
        if (std::memchr(&inner.values[first], 1, run.end - run.begin) == nullptr) return;
        part_has_inner[run.part] = true;
        room_has_inner[ground.values[first]] = true;
    });
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        // A room that is all rim stays: it has nothing else to show.
        if (part_has_inner[run.part] || !room_has_inner[ground.values[first]]) return;
        std::fill_n(&ground.values[first], run.end - run.begin, std::uint16_t{0});
    });
}

/// Labels may reach over the face of a wall: what is not free along the rim of a room is taken from
/// it, and so is what that cuts off. Further in, it is furniture.
void return_rims_to_walls(FloorCells& cells, std::int32_t rim_cells, const Executor& executor) {
    if (rim_cells < 1) return;
    const Raster<std::uint8_t> inner = find_inner_cells(cells.ground, rim_cells - 1, executor);
    std::atomic<bool> any{false};
    for_cells(executor, inner.values.size(), [&](std::size_t first, std::size_t last) {
        const std::uint8_t* const is_inner = inner.values.data();
        std::uint8_t* const furniture = cells.furniture.values.data();
        for (std::size_t i = first; i < last; ++i) {
            if (furniture[i] == 0 || is_inner[i] != 0) continue;
            cells.ground.values[i] = furniture[i] == kFurniture ? kWall : std::uint16_t{0};
            furniture[i] = 0;
            any = true;
        }
    });
    if (any) take_cut_off_parts(cells.ground, inner, executor);
}

std::vector<bool> are_shorter(const std::vector<Box>& bounds, std::int32_t max_side_cells) {
    std::vector<bool> result(bounds.size());
    for (std::size_t i = 1; i < bounds.size(); ++i) {
        result[i] = std::max(bounds[i].width(), bounds[i].height()) <= max_side_cells;
    }
    return result;
}

/// What one room encloses and is not too large becomes furniture.
void find_furniture(FloorCells& cells, std::size_t max_cells, const Executor& executor) {
    Raster<std::uint16_t>& ground = cells.ground;
    const auto add = [&](const CellRun& run, std::size_t first, std::uint16_t room) {
        for (std::size_t place = first; place < first + (run.end - run.begin); ++place) {
            const std::uint16_t was = std::exchange(ground.values[place], room);
            if (was == kWall) cells.furniture.values[place] = kFurniture;
            if (was == 0) cells.furniture.values[place] = kFurnitureInside;
        }
    };
    for_each_enclosed_run(ground, is_room, max_cells, executor, add);
}

/// Adds the free cells to the mask that nothing but walls touches.
void add_shut_in_cells(const Raster<std::uint16_t>& ground, Raster<std::uint8_t>& is_hidden,
                       const Executor& executor) {
    const Raster<std::uint8_t> is_loose = mask_of(ground, kLooseFree, executor);
    if (!is_any_set(is_loose)) return;
    const ConnectedParts parts = parts_of(is_loose, executor);
    std::vector<bool> is_shut_in = parts.on_edge();
    is_shut_in.flip();
    const std::vector<BorderTally> tallies = tally_borders(ground, is_loose, parts, is_shut_in);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        if (!is_shut_in[run.part] || tallies[run.part].num_room_edges > 0) return;
        std::fill_n(&is_hidden.values[first], run.end - run.begin, std::uint8_t{1});
    });
}

/// Unknown cells, and free ones that nothing but walls touches: thin parts are walls, patches of a
/// moderate size are furniture, and the rest stays.
void mark_hidden_cells(FloorCells& cells, std::int32_t max_wall_cells,
                       std::int32_t max_furniture_cells, const Executor& executor) {
    Raster<std::uint16_t>& ground = cells.ground;
    Raster<std::uint8_t> is_hidden = mask_of(ground, 0, executor);
    add_shut_in_cells(ground, is_hidden, executor);
    const Raster<std::uint8_t> thick = find_thick_parts(is_hidden, max_wall_cells + 1, executor);
    const ConnectedParts parts = parts_of(is_hidden, executor);
    std::vector<bool> is_furniture = are_shorter(bounds_of(parts), max_furniture_cells);
    const std::vector<BorderTally> tallies = tally_borders(ground, is_hidden, parts, is_furniture);
    for (std::size_t i = 1; i < tallies.size(); ++i) {
        const BorderTally& tally = tallies[i];
        const bool enclosed = tally.num_room_edges + tally.num_wall_edges == tally.num_edges;
        is_furniture[i] = is_furniture[i] && enclosed;
    }
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        for (std::size_t i = first; i < first + (run.end - run.begin); ++i) {
            if (thick.values[i] == 0) {
                ground.values[i] = kWallCore;
            } else if (is_furniture[run.part]) {
                cells.furniture.values[i] = kFurnitureInside;
            }
        }
    });
}

/// Of solid blocks, and of maps whose outside is occupied, a wall's thickness is drawn.
void hollow_out_blocks(Raster<std::uint16_t>& ground, std::int32_t max_wall_cells,
                       const Executor& executor) {
    Raster<std::uint8_t> thick =
        find_thick_parts(mask_of(ground, kWall, executor), 2 * max_wall_cells, executor);
    if (!is_any_set(thick)) return;
    const Raster<std::uint8_t> deep =
        find_deep_parts(thick, std::max(max_wall_cells / 2, 1), executor);
    for_cells(executor, ground.values.size(), [&](std::size_t first, std::size_t last) {
        std::transform(deep.values.data() + first, deep.values.data() + last,
                       ground.values.data() + first, ground.values.data() + first,
                       [](std::uint8_t is_deep, std::uint16_t cell) {
                           return is_deep != 0 ? std::uint16_t{0} : cell;
                       });
    });
}

/// A thin part whose sides are occupied rather than rooms is the inside of a wall, and a speck
/// beside one belongs to it. The others may be gaps between the beams of a laser.
void fill_walls(Raster<std::uint16_t>& ground, const Executor& executor) {
    constexpr std::size_t kSpeckCells = 3;
    const Raster<std::uint8_t> is_core = mask_of(ground, kWallCore, executor);
    if (!is_any_set(is_core)) return;
    const ConnectedParts parts = parts_of(is_core, executor);
    const std::vector<BorderTally> tallies = tally_borders(
        ground, is_core, parts, std::vector<bool>(parts.count + std::size_t{1}, true));
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        const BorderTally& tally = tallies[run.part];
        const bool speck = tally.num_cells <= kSpeckCells && tally.num_wall_edges > 0;
        if (!speck && tally.num_wall_edges < tally.num_room_edges) return;
        std::fill_n(&ground.values[first], run.end - run.begin, kWall);
    });
}

}  // namespace

FloorCells sort_floor_cells(const GridMap& map, const Raster<std::uint16_t>& labels,
                            const Executor& executor) {
    FloorCells cells = classify(map, labels, executor);
    return_rims_to_walls(cells, to_cells(kRimMetres, map.resolution_m), executor);
    find_furniture(cells, max_furniture_cells(map.resolution_m), executor);
    const std::int32_t max_wall_cells =
        std::min(to_cells(kMaxWallMetres, map.resolution_m), kMaxWallCells);
    mark_hidden_cells(cells, max_wall_cells, to_cells(kMaxFurnitureMetres, map.resolution_m),
                      executor);
    fill_walls(cells.ground, executor);
    hollow_out_blocks(cells.ground, std::max(max_wall_cells, 2), executor);
    return cells;
}

}  // namespace quadcut::draw
