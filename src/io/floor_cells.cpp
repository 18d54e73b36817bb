// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/floor_cells.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "io/connected_cells.hpp"
#include "io/thick_parts.hpp"

namespace quadcut::io {
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

/// A rectangle of cells as it grows; empty at first.
struct Bounds {
    Cell low{INT32_MAX, INT32_MAX};
    Cell high{INT32_MIN, INT32_MIN};

    void add(std::int32_t x, std::int32_t y) {
        low = {std::min(low.x, x), std::min(low.y, y)};
        high = {std::max(high.x, x), std::max(high.y, y)};
    }
    [[nodiscard]] bool empty() const { return high.x < low.x; }
};

/// The cells for which `wanted(offset)` holds.
template <typename Wanted>
Bounds bounds_of(const Raster<CellState>& states, const Wanted& wanted) {
    Bounds bounds;
    std::size_t place = 0;
    for (std::int32_t y = 0; y < states.height; ++y) {
        for (std::int32_t x = 0; x < states.width; ++x, ++place) {
            if (wanted(place)) bounds.add(x, y);
        }
    }
    return bounds;
}

/// The part of the map to draw, as places within its raster.
Bounds find_frame(const GridMap& map, const Raster<std::uint16_t>& labels) {
    const Raster<CellState>& states = map.states;
    Bounds frame = bounds_of(states, [&](std::size_t i) { return labels.values[i] != 0; });
    if (frame.empty()) {
        frame = bounds_of(states,
                          [&](std::size_t i) { return states.values[i] != CellState::unknown; });
    }
    if (frame.empty()) return {{0, 0}, {states.width - 1, states.height - 1}};
    const std::int32_t margin = to_cells(kMarginMetres, map.resolution_m);
    return {{std::max(0, frame.low.x - margin), std::max(0, frame.low.y - margin)},
            {std::min(states.width - 1, frame.high.x + margin),
             std::min(states.height - 1, frame.high.y + margin)}};
}

FloorCells classify(const GridMap& map, const Raster<std::uint16_t>& labels) {
    const Bounds frame = find_frame(map, labels);
    const std::int32_t width = frame.high.x - frame.low.x + 1;
    const std::int32_t height = frame.high.y - frame.low.y + 1;
    const Cell origin{map.states.origin.x + frame.low.x, map.states.origin.y + frame.low.y};
    FloorCells cells{{origin, width, height}, {origin, width, height}};
    std::size_t to = 0;
    for (std::int32_t y = 0; y < height; ++y) {
        std::size_t from = map.states.offset({origin.x, origin.y + y});
        for (std::int32_t x = 0; x < width; ++x, ++from, ++to) {
            const CellState state = map.states.values[from];
            if (labels.values[from] != 0) {
                cells.ground.values[to] = labels.values[from];
                // A room's label covers what stands in it, too: an obstacle is still to be seen.
                if (state == CellState::occupied) cells.furniture.values[to] = kFurniture;
                if (state == CellState::unknown) cells.furniture.values[to] = kFurnitureInside;
            } else if (state == CellState::occupied) {
                cells.ground.values[to] = kWall;
            } else if (state == CellState::free) {
                cells.ground.values[to] = kLooseFree;
            }
        }
    }
    return cells;
}

bool is_room(std::uint32_t ground) { return ground > 0 && ground < kFirstNonRoom; }

/// The cells of rooms that have only their own room around them, `margin_cells` far.
Raster<std::uint8_t> find_inner_cells(const Raster<std::uint32_t>& ground,
                                      std::int32_t margin_cells) {
    Raster<std::uint8_t> mask(ground.origin, ground.width, ground.height);
    const auto width = static_cast<std::size_t>(ground.width);
    std::size_t place = 0;
    for (std::int32_t y = 0; y < ground.height; ++y) {
        for (std::int32_t x = 0; x < ground.width; ++x, ++place) {
            const std::uint32_t room = ground.values[place];
            const auto same = [&](std::size_t neighbour) {
                return ground.values[neighbour] == room;
            };
            const bool within = x > 0 && y > 0 && x + 1 < ground.width && y + 1 < ground.height;
            const bool inner = within && is_room(room) && same(place - 1) && same(place + 1) &&
                               same(place - width) && same(place + width);
            mask.values[place] = inner ? 1 : 0;
        }
    }
    return find_deep_parts(mask, margin_cells);
}

/// Labels may reach over the face of a wall: what is not free along the rim of a room is taken from
/// it, and so is what that cuts off. Further in, it is furniture.
void return_rims_to_walls(FloorCells& cells, std::int32_t rim_cells) {
    if (rim_cells < 1) return;
    Raster<std::uint32_t>& ground = cells.ground;
    const Raster<std::uint8_t> inner = find_inner_cells(ground, rim_cells - 1);
    bool any = false;
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        if (inner.values[i] != 0 || cells.furniture.values[i] == 0) continue;
        ground.values[i] = cells.furniture.values[i] == kFurniture ? kWall : 0;
        cells.furniture.values[i] = 0;
        any = true;
    }
    if (!any) return;
    Raster<std::uint32_t> rooms = ground;
    for (std::uint32_t& room : rooms.values) room = is_room(room) ? room : 0;
    const CellRegions parts = number_connected(std::move(rooms));
    std::vector<std::uint8_t> part_has_inner(parts.values.size() + 1);
    std::vector<std::uint8_t> room_has_inner(kFirstNonRoom);
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        if (inner.values[i] == 0) continue;
        part_has_inner[parts.numbers.values[i]] = 1;
        if (is_room(ground.values[i])) room_has_inner[ground.values[i]] = 1;
    }
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        const std::uint32_t part = parts.numbers.values[i];
        if (part == 0 || part_has_inner[part] != 0) continue;
        // A room that is all rim stays: it has nothing else to show.
        if (room_has_inner[ground.values[i]] != 0) ground.values[i] = 0;
    }
}

/// Finds patches of cells without a room that one room encloses, and makes furniture of them.
class FurnitureFinder {
public:
    FurnitureFinder(FloorCells& cells, std::int32_t max_side_cells)
        : cells_(cells),
          max_side_cells_(max_side_cells),
          patch_of_(cells.ground.values.size(), 0) {}

    void run() {
        const Raster<std::uint32_t>& ground = cells_.ground;
        for (std::size_t i = 1; i < ground.values.size(); ++i) {
            // A patch inside a room has that room to the left of its lowest row.
            const bool starts = !is_room(ground.values[i]) && is_room(ground.values[i - 1]);
            if (!starts || patch_of_[i] != 0) continue;
            if (collect(i, ground.values[i - 1])) take_patch(ground.values[i - 1]);
        }
    }

private:
    /// Gathers the 8-connected patch that holds `start`. False as soon as it is too long or meets
    /// another room, the frame, or a patch given up before (then it is part of that one).
    bool collect(std::size_t start, std::uint32_t room) {
        const Raster<std::uint32_t>& ground = cells_.ground;
        patch_.assign(1, start);
        patch_of_[start] = ++num_patches_;
        Bounds bounds;
        for (std::size_t next = 0; next < patch_.size(); ++next) {
            const auto width = static_cast<std::size_t>(ground.width);
            const auto x = static_cast<std::int32_t>(patch_[next] % width);
            const auto y = static_cast<std::int32_t>(patch_[next] / width);
            bounds.add(x, y);
            const bool at_frame =
                x == 0 || y == 0 || x == ground.width - 1 || y == ground.height - 1;
            if (at_frame || bounds.high.x - bounds.low.x >= max_side_cells_ ||
                bounds.high.y - bounds.low.y >= max_side_cells_) {
                return false;
            }
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                for (std::int32_t dx = -1; dx <= 1; ++dx) {
                    const std::size_t place =
                        static_cast<std::size_t>(y + dy) * width + static_cast<std::size_t>(x + dx);
                    if (is_room(ground.values[place])) {
                        if (ground.values[place] != room) return false;
                    } else if (patch_of_[place] == 0) {
                        patch_of_[place] = num_patches_;
                        patch_.push_back(place);
                    } else if (patch_of_[place] != num_patches_) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    void take_patch(std::uint32_t room) {
        for (const std::size_t place : patch_) {
            std::uint32_t& ground = cells_.ground.values[place];
            if (ground == kWall) cells_.furniture.values[place] = kFurniture;
            if (ground == 0) cells_.furniture.values[place] = kFurnitureInside;
            ground = room;
        }
    }

    FloorCells& cells_;
    std::int32_t max_side_cells_;
    std::vector<std::uint32_t> patch_of_;
    std::uint32_t num_patches_ = 0;
    std::vector<std::size_t> patch_;
};

/// What lies along the border of a 4-connected region.
struct RegionTally {
    Bounds bounds;
    std::size_t num_cells = 0;
    std::size_t num_edges = 0;
    std::size_t num_room_edges = 0;
    std::size_t num_wall_edges = 0;
};

struct TalliedRegions {
    Raster<std::uint32_t> numbers;
    std::vector<RegionTally> tallies;
};

TalliedRegions tally_regions(const Raster<std::uint32_t>& ground,
                             const Raster<std::uint8_t>& mask) {
    Raster<std::uint32_t> values(ground.origin, ground.width, ground.height);
    std::copy(mask.values.begin(), mask.values.end(), values.values.begin());
    CellRegions regions = number_connected(std::move(values));
    TalliedRegions result{std::move(regions.numbers),
                          std::vector<RegionTally>(regions.values.size())};
    if (result.tallies.empty()) return result;

    const auto width = static_cast<std::size_t>(ground.width);
    std::size_t place = 0;
    for (std::int32_t y = 0; y < ground.height; ++y) {
        for (std::int32_t x = 0; x < ground.width; ++x, ++place) {
            const std::uint32_t number = result.numbers.values[place];
            if (number == 0) continue;
            RegionTally& tally = result.tallies[number - 1];
            tally.bounds.add(x, y);
            ++tally.num_cells;
            const auto look = [&](bool exists, std::size_t neighbour) {
                if (!exists || result.numbers.values[neighbour] == number) return;
                ++tally.num_edges;
                if (is_room(ground.values[neighbour])) ++tally.num_room_edges;
                if (ground.values[neighbour] == kWall) ++tally.num_wall_edges;
            };
            look(x > 0, place - 1);
            look(x + 1 < ground.width, place + 1);
            look(y > 0, place - width);
            look(y + 1 < ground.height, place + width);
        }
    }
    return result;
}

TalliedRegions tally_regions(const Raster<std::uint32_t>& ground, std::uint32_t value) {
    Raster<std::uint8_t> mask(ground.origin, ground.width, ground.height);
    std::transform(ground.values.begin(), ground.values.end(), mask.values.begin(),
                   [value](std::uint32_t cell) { return cell == value ? 1 : 0; });
    return tally_regions(ground, mask);
}

/// Whether a region of the raster ends where the raster does: then more of it may be outside.
bool meets_frame(const Bounds& bounds, const Raster<std::uint32_t>& ground) {
    return bounds.low.x == 0 || bounds.low.y == 0 || bounds.high.x == ground.width - 1 ||
           bounds.high.y == ground.height - 1;
}

/// Unknown cells, and free ones that nothing but walls touches: thin parts are walls, patches of a
/// moderate size are furniture, and the rest stays.
void mark_hidden_cells(FloorCells& cells, std::int32_t max_wall_cells,
                       std::int32_t max_furniture_cells) {
    Raster<std::uint32_t>& ground = cells.ground;
    const TalliedRegions loose = tally_regions(ground, kLooseFree);
    Raster<std::uint8_t> is_hidden(ground.origin, ground.width, ground.height);
    for (std::size_t i = 0; i < is_hidden.values.size(); ++i) {
        const std::uint32_t number = loose.numbers.values[i];
        const bool shut_in = number > 0 && loose.tallies[number - 1].num_room_edges == 0 &&
                             !meets_frame(loose.tallies[number - 1].bounds, ground);
        is_hidden.values[i] = ground.values[i] == 0 || shut_in ? 1 : 0;
    }
    const Raster<std::uint8_t> thick = find_thick_parts(is_hidden, max_wall_cells + 1);
    const TalliedRegions hidden = tally_regions(ground, is_hidden);
    for (std::size_t i = 0; i < is_hidden.values.size(); ++i) {
        if (is_hidden.values[i] == 0) continue;
        if (thick.values[i] == 0) {
            ground.values[i] = kWallCore;
            continue;
        }
        const RegionTally& tally = hidden.tallies[hidden.numbers.values[i] - 1];
        const bool small = tally.bounds.high.x - tally.bounds.low.x < max_furniture_cells &&
                           tally.bounds.high.y - tally.bounds.low.y < max_furniture_cells;
        const bool enclosed = tally.num_room_edges + tally.num_wall_edges == tally.num_edges;
        if (small && enclosed) cells.furniture.values[i] = kFurnitureInside;
    }
}

/// Of solid blocks, and of maps whose outside is occupied, a wall's thickness is drawn.
void hollow_out_blocks(Raster<std::uint32_t>& ground, std::int32_t max_wall_cells) {
    Raster<std::uint8_t> is_wall(ground.origin, ground.width, ground.height);
    std::transform(ground.values.begin(), ground.values.end(), is_wall.values.begin(),
                   [](std::uint32_t cell) { return cell == kWall ? 1 : 0; });
    const Raster<std::uint8_t> thick = find_thick_parts(is_wall, 2 * max_wall_cells);
    if (std::find(thick.values.begin(), thick.values.end(), 1) == thick.values.end()) return;
    const Raster<std::uint8_t> deep = find_deep_parts(thick, std::max(max_wall_cells / 2, 1));
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        if (deep.values[i] != 0) ground.values[i] = 0;
    }
}

/// A thin part whose sides are occupied rather than rooms is the inside of a wall, and a speck
/// beside one belongs to it. The others may be gaps between the beams of a laser.
void fill_walls(Raster<std::uint32_t>& ground) {
    constexpr std::size_t kSpeckCells = 3;
    const TalliedRegions cores = tally_regions(ground, kWallCore);
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        const std::uint32_t number = cores.numbers.values[i];
        if (number == 0) continue;
        const RegionTally& tally = cores.tallies[number - 1];
        const bool speck = tally.num_cells <= kSpeckCells && tally.num_wall_edges > 0;
        if (speck || tally.num_wall_edges >= tally.num_room_edges) ground.values[i] = kWall;
    }
}

}  // namespace

FloorCells sort_floor_cells(const GridMap& map, const Raster<std::uint16_t>& labels) {
    FloorCells cells = classify(map, labels);
    return_rims_to_walls(cells, to_cells(kRimMetres, map.resolution_m));
    const std::int32_t max_furniture_cells = to_cells(kMaxFurnitureMetres, map.resolution_m);
    FurnitureFinder(cells, max_furniture_cells).run();
    const std::int32_t max_wall_cells =
        std::min(to_cells(kMaxWallMetres, map.resolution_m), kMaxWallCells);
    mark_hidden_cells(cells, max_wall_cells, max_furniture_cells);
    fill_walls(cells.ground);
    hollow_out_blocks(cells.ground, std::max(max_wall_cells, 2));
    return cells;
}

}  // namespace quadcut::io
