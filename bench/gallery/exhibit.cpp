// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/exhibit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "eval/labels.hpp"

namespace quadcut::gallery {
namespace {

Side as_side(const GridMap& map, const io::LabelImage& image) {
    Side side;
    side.map = map;
    Raster<std::uint16_t>& labels = side.rooms.labels;
    labels = Raster<std::uint16_t>(map.states.origin, image.width, image.height);
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        const std::size_t row = static_cast<std::size_t>(image.height) - 1 - i / width;
        labels.values[row * width + i % width] = static_cast<std::uint16_t>(image.values[i]);
    }
    for (std::uint32_t number = 1; number <= image.num_regions; ++number) {
        Room room;
        room.id = RoomId{number};
        room.kind = RoomKind::room;
        side.rooms.rooms.push_back(room);
    }
    return side;
}

}  // namespace

Exhibit make_exhibit(std::string name, const GridMap& truth_map, const io::LabelImage& truth,
                     const GridMap& result_map, const Segmentation& result,
                     const std::optional<io::FreeMask>& surely_free) {
    io::LabelImage predicted = as_label_image(result.labels);
    if (surely_free) predicted = eval::without_void(predicted, truth, surely_free);
    Exhibit exhibit{std::move(name), as_side(truth_map, truth), as_side(result_map, predicted),
                    compare(predicted, truth), Raster<std::uint8_t>(result.labels.box())};
    // Regions leave out specks: the rooms' ids move up.
    std::vector<std::uint32_t> region_of(result.rooms.size() + 1);
    const Raster<std::uint16_t>& regions = exhibit.result.rooms.labels;
    for (std::size_t i = 0; i < regions.values.size(); ++i) {
        region_of[result.labels.values[i]] = regions.values[i];
        const bool is_left_out = result.labels.values[i] != 0 && regions.values[i] == 0;
        exhibit.left_out.values[i] = is_left_out ? 1 : 0;
    }
    for (const Room& room : result.rooms) {
        const std::uint32_t region = region_of[index(room.id)];
        if (region > 0) exhibit.result.rooms.rooms[region - 1].kind = room.kind;
    }
    for (Door door : result.doors) {
        door.a = RoomId{region_of[index(door.a)]};
        door.b = RoomId{region_of[index(door.b)]};
        if (index(door.a) > 0 && index(door.b) > 0) exhibit.result.rooms.doors.push_back(door);
    }
    return exhibit;
}

Side resampled(const GridMap& frame, const GridMap& map, const Segmentation& rooms) {
    Side side;
    side.map = frame;
    side.rooms.rooms = rooms.rooms;
    side.rooms.doors = rooms.doors;
    const Raster<CellState>& cells = frame.states;
    side.rooms.labels = Raster<std::uint16_t>(cells.origin, cells.width, cells.height);
    const Pose image_from_map = inverse(map.map_from_image);
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
        const Cell cell = cells.cell(i);
        const Point center{(cell.x + 0.5) * frame.resolution_m,
                           (cell.y + 0.5) * frame.resolution_m};
        const Point at = transform(image_from_map, transform(frame.map_from_image, center));
        const Cell from{static_cast<std::int32_t>(std::floor(at.x / map.resolution_m)),
                        static_cast<std::int32_t>(std::floor(at.y / map.resolution_m))};
        const bool known = map.states.contains(from);
        side.map.states.values[i] = known ? map.states.at(from) : CellState::unknown;
        if (known) side.rooms.labels.values[i] = rooms.labels.at(from);
    }
    return side;
}

}  // namespace quadcut::gallery
