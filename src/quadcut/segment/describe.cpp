// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/describe.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/segment/label_tally.hpp"

namespace quadcut {
namespace {

constexpr double kCorridorMinElongation = 3.5;
constexpr double kCorridorMaxWidthM = 4.5;
constexpr double kHallMinAreaM2 = 80.0;
constexpr std::size_t kRowsPerChunk = 64;

/// 1 where all four neighbours have the cell's own label: the cells inside a region's border.
Raster<std::uint8_t> interior_of_regions(const Raster<std::uint32_t>& labels,
                                         const Executor& executor) {
    Raster<std::uint8_t> interior(labels.box(), 0, executor);
    const auto width = static_cast<std::size_t>(labels.width);
    const auto height = static_cast<std::size_t>(labels.height);
    if (height < 3) return interior;
    parallel_for(executor, height - 2, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first + 1; y < last + 1; ++y) {
            const std::uint32_t* const own = &labels.values[y * width];
            const std::uint32_t* const below = own - width;
            const std::uint32_t* const above = own + width;
            std::uint8_t* const inside = &interior.values[y * width];
            for (std::size_t x = 1; x + 1 < width; ++x) {
                const std::uint32_t label = own[x];
                const std::uint32_t differs = (own[x - 1] ^ label) | (own[x + 1] ^ label) |
                                              (below[x] ^ label) | (above[x] ^ label);
                const bool is_inside = (differs == 0) & (label != 0);
                inside[x] = static_cast<std::uint8_t>(is_inside);
            }
        }
    });
    return interior;
}

struct Shape {
    std::size_t num_cells = 0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    /// The free cell farthest from the region's border, and that distance.
    Cell deepest;
    float depth_m = -1.0F;
};

std::vector<Shape> measure_shapes(const Raster<std::uint32_t>& labels, std::uint32_t count,
                                  const GridMap& map, const Layout& layout,
                                  const Executor& executor, Raster<float> memory) {
    const Raster<float> depth = clearance_m(interior_of_regions(labels, executor), map.resolution_m,
                                            executor, std::move(memory));
    auto shapes = tally_by_label<Shape>(
        labels, executor,
        [&](Shape& shape, const LabelRun& run) {
            const Cell first = labels.cell(run.offset);
            const auto length = static_cast<double>(run.num_cells);
            shape.num_cells += run.num_cells;
            shape.sum_x += length * (first.x + 0.5 * length);
            shape.sum_y += length * (first.y + 0.5);
            const float* const depths = &depth.values[run.offset];
            if (largest(depths, run.num_cells, shape.depth_m) <= shape.depth_m) return;
            for (std::size_t k = 0; k < run.num_cells; ++k) {
                if (depths[k] <= shape.depth_m) continue;
                const Cell cell{first.x + static_cast<std::int32_t>(k), first.y};
                if (map.states.at(layout.source(cell)) != CellState::free) continue;
                shape.depth_m = depths[k];
                shape.deepest = cell;
            }
        },
        [](Shape& shape, const Shape& other) {
            shape.num_cells += other.num_cells;
            shape.sum_x += other.sum_x;
            shape.sum_y += other.sum_y;
            if (other.depth_m > shape.depth_m) {
                shape.depth_m = other.depth_m;
                shape.deepest = other.deepest;
            }
        });
    shapes.resize(count + std::size_t{1});
    return shapes;
}

/// A corridor is long for its width and leads somewhere; a hall is large.
RoomKind kind_of(const Shape& shape, double area_m2, double resolution_m, std::size_t num_doors) {
    const double width_m = 2.0 * (static_cast<double>(shape.depth_m) + resolution_m);
    const double elongation = area_m2 / (width_m * width_m);
    if (elongation >= kCorridorMinElongation && width_m <= kCorridorMaxWidthM && num_doors >= 2) {
        return RoomKind::corridor;
    }
    return area_m2 >= kHallMinAreaM2 ? RoomKind::hall : RoomKind::room;
}

}  // namespace

std::string default_name(RoomKind kind, RoomId id) {
    const char* const word = kind == RoomKind::corridor ? "corridor "
                             : kind == RoomKind::hall   ? "hall "
                                                        : "room ";
    return word + std::to_string(index(id));
}

std::uint32_t number_in_reading_order(Raster<std::uint32_t>& labels, const Layout& layout,
                                      const Executor& executor) {
    struct First {
        Cell cell;
        std::uint32_t label = 0;
        bool operator<(const First& other) const {
            if ((label == 0) != (other.label == 0)) return label != 0;
            return std::pair{-cell.y, cell.x} < std::pair{-other.cell.y, other.cell.x};
        }
    };
    std::vector<First> firsts = tally_by_label<First>(
        labels, executor,
        [&](First& first, const LabelRun& run) {
            // Of a run one end or the other comes first, however it is turned.
            for (const std::size_t end : {run.offset, run.offset + run.num_cells - 1}) {
                const First own{layout.source(labels.cell(end)), labels.values[end]};
                if (own < first) first = own;
            }
        },
        [](First& first, const First& other) {
            if (other < first) first = other;
        });
    std::vector<std::uint32_t> number(firsts.size(), 0);
    std::sort(firsts.begin(), firsts.end());
    std::uint32_t count = 0;
    for (const First& first : firsts) {
        if (first.label != 0) number[first.label] = ++count;
    }
    renumber(labels, number, executor);
    return count;
}

std::vector<Room> describe_rooms(const Raster<std::uint32_t>& labels, std::uint32_t count,
                                 const GridMap& map, const Layout& layout,
                                 const std::vector<Door>& doors, const Executor& executor,
                                 Raster<float> memory) {
    std::vector<std::size_t> num_doors(count + 1, 0);
    for (const Door& door : doors) {
        ++num_doors[index(door.a)];
        ++num_doors[index(door.b)];
    }
    const std::vector<Shape> shapes =
        measure_shapes(labels, count, map, layout, executor, std::move(memory));
    const LaidOutFrame frame{layout, map.resolution_m, map.map_from_image};
    std::vector<Room> rooms;
    rooms.reserve(count);
    for (std::uint32_t id = 1; id <= count; ++id) {
        const Shape& shape = shapes[id];
        const auto num_cells = static_cast<double>(shape.num_cells);
        Room room;
        room.id = RoomId{id};
        room.area_m2 = num_cells * map.resolution_m * map.resolution_m;
        room.kind = kind_of(shape, room.area_m2, map.resolution_m, num_doors[id]);
        room.name = default_name(room.kind, room.id);
        room.centroid = frame.in_map({shape.sum_x / num_cells, shape.sum_y / num_cells});
        room.label_point = frame.in_map({shape.deepest.x + 0.5, shape.deepest.y + 0.5});
        rooms.push_back(std::move(room));
    }
    return rooms;
}

}  // namespace quadcut
