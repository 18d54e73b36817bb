// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/describe.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <string>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/enclosed_patches.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

constexpr double kCorridorMinElongation = 3.5;
constexpr double kCorridorMaxWidthM = 4.5;
/// So long, and so long for its usual width, a room is a passage, be there a lobby in it or no
/// door.
constexpr double kPassageMinElongation = 10.0;
constexpr double kPassageMinLengthM = 15.0;
constexpr double kPassageMaxWidthM = 6.0;
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

std::vector<Shape> measure_shapes(const Raster<std::uint32_t>& labels, const GridMap& map,
                                  const Layout& layout, const Raster<float>& depth,
                                  const Executor& executor) {
    return tally_by_label<Shape>(
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
}

/// Every second cell of every second row, which is fine enough for widths, with what stands in a
/// region as part of it.
Raster<std::uint32_t> sample_filled_regions(const Raster<std::uint32_t>& labels,
                                            double resolution_m, const Executor& executor) {
    Raster<std::uint32_t> samples({0, 0}, (labels.width + 1) / 2, (labels.height + 1) / 2);
    const auto width = static_cast<std::size_t>(labels.width);
    const auto num_columns = static_cast<std::size_t>(samples.width);
    parallel_for(executor, static_cast<std::size_t>(samples.height), kRowsPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t y = first; y < last; ++y) {
                         const std::uint32_t* const row = &labels.values[2 * y * width];
                         std::uint32_t* const to = &samples.values[y * num_columns];
                         for (std::size_t x = 0; x < num_columns; ++x) to[x] = row[2 * x];
                     }
                 });
    const auto is_room = [](std::uint32_t label) { return label != 0; };
    for_each_enclosed_run(labels, is_room, max_furniture_cells(resolution_m), executor,
                          [&](const CellRun& run, std::size_t first, std::uint32_t room) {
                              const std::size_t y = first / width;
                              if (y % 2 != 0) return;
                              std::uint32_t* const to = &samples.values[y / 2 * num_columns];
                              std::fill(to + (run.begin + 1) / 2, to + (run.end + 1) / 2, room);
                          });
    return samples;
}

/// A region and what stands in it: how far its cells are from its outer border.
struct Outline {
    std::size_t num_cells = 0;
    double sum_depth_m = 0.0;
    float max_depth_m = 0.0F;
};

/// Of each region of a raster; `memory` as of clearance_m().
std::vector<Outline> measure_outlines(const Raster<std::uint32_t>& regions, double resolution_m,
                                      const Executor& executor, Raster<float> memory) {
    const Raster<float> depth = clearance_m(interior_of_regions(regions, executor), resolution_m,
                                            executor, std::move(memory));
    return tally_by_label<Outline>(
        regions, executor,
        [&](Outline& outline, const LabelRun& run) {
            const float* const depths = &depth.values[run.offset];
            outline.num_cells += run.num_cells;
            outline.sum_depth_m =
                std::accumulate(depths, depths + run.num_cells, outline.sum_depth_m);
            outline.max_depth_m = largest(depths, run.num_cells, outline.max_depth_m);
        },
        [](Outline& outline, const Outline& other) {
            outline.num_cells += other.num_cells;
            outline.sum_depth_m += other.sum_depth_m;
            outline.max_depth_m = std::max(outline.max_depth_m, other.max_depth_m);
        });
}

/// What a default name begins with.
std::string word_for(Seen seen, RoomKind kind) {
    if (seen == Seen::glimpse) return "glimpse ";
    return kind == RoomKind::corridor ? "corridor " : kind == RoomKind::hall ? "hall " : "room ";
}

/// A corridor is long for its width and leads somewhere, or is very long; a hall is large.
RoomKind kind_of(const Outline& outline, double resolution_m, std::size_t num_doors) {
    const auto num_cells = static_cast<double>(std::max<std::size_t>(outline.num_cells, 1));
    const double area_m2 = num_cells * resolution_m * resolution_m;
    const double widest_m = 2.0 * (static_cast<double>(outline.max_depth_m) + resolution_m);
    // Between parallel walls, cells are a quarter of the width from them in the mean.
    const double usual_width_m = 4.0 * (outline.sum_depth_m / num_cells + resolution_m);
    const bool leads_on = num_doors >= 2 && widest_m <= kCorridorMaxWidthM &&
                          area_m2 >= kCorridorMinElongation * widest_m * widest_m;
    const double length_m = area_m2 / usual_width_m;
    const bool is_passage = usual_width_m <= kPassageMaxWidthM && length_m >= kPassageMinLengthM &&
                            length_m >= kPassageMinElongation * usual_width_m;
    if (leads_on || is_passage) return RoomKind::corridor;
    return area_m2 >= kHallMinAreaM2 ? RoomKind::hall : RoomKind::room;
}

}  // namespace

std::string default_name(const Room& room) {
    return word_for(room.seen, room.kind) + std::to_string(index(room.id));
}

RoomId room_with_default_name(std::string_view name) {
    std::uint32_t id = 0;
    // From the first character on where there is no space.
    const std::size_t begin = name.rfind(' ') + 1;
    std::from_chars(name.data() + begin, name.data() + name.size(), id);
    const std::string number = std::to_string(id);
    for (const RoomKind kind : {RoomKind::room, RoomKind::corridor, RoomKind::hall}) {
        if (word_for(Seen::whole, kind) + number == name) return RoomId{id};
    }
    return word_for(Seen::glimpse, {}) + number == name ? RoomId{id} : RoomId{};
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
    Raster<float> depth = clearance_m(interior_of_regions(labels, executor), map.resolution_m,
                                      executor, std::move(memory));
    std::vector<Shape> shapes = measure_shapes(labels, map, layout, depth, executor);
    const double sample_m = 2.0 * map.resolution_m;
    std::vector<Outline> outlines =
        measure_outlines(sample_filled_regions(labels, map.resolution_m, executor), sample_m,
                         executor, std::move(depth));
    shapes.resize(count + std::size_t{1});
    outlines.resize(count + std::size_t{1});
    const LaidOutFrame frame{layout, map.resolution_m, map.map_from_image};
    std::vector<Room> rooms;
    rooms.reserve(count);
    for (std::uint32_t id = 1; id <= count; ++id) {
        const Shape& shape = shapes[id];
        const auto num_cells = static_cast<double>(shape.num_cells);
        Room room;
        room.id = RoomId{id};
        room.area_m2 = num_cells * map.resolution_m * map.resolution_m;
        room.kind = kind_of(outlines[id], sample_m, num_doors[id]);
        room.name = default_name(room);
        room.centroid = frame.in_map({shape.sum_x / num_cells, shape.sum_y / num_cells});
        room.label_point = frame.in_map({shape.deepest.x + 0.5, shape.deepest.y + 0.5});
        rooms.push_back(std::move(room));
    }
    return rooms;
}

}  // namespace quadcut
