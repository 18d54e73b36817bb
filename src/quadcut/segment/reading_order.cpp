// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/reading_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "quadcut/map/line_walk.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

/// Where a reader looks for a room on the page, metres from its upper left corner, y down: at the
/// middle of its area, or where that is outside of it, at its label point.
Point place_on_page(const Room& room, const Raster<std::uint16_t>& labels, const GridMap& map) {
    const Pose image_from_map = inverse(map.map_from_image);
    Point at = transform(image_from_map, room.centroid);
    const Cell cell = cell_of({at.x / map.resolution_m, at.y / map.resolution_m});
    const bool is_inside = labels.contains(cell) && labels.at(cell) == index(room.id);
    if (!is_inside) at = transform(image_from_map, room.label_point);
    return {at.x, -at.y};
}

/// Where a room is on the page.
struct Place {
    Point at;
    std::uint32_t label = 0;
};

/// Row by row, from left to right. What is less than three quarters of a usual room's size lower
/// than the first of a row is in that row. At least one, with their areas.
void put_in_reading_order(std::vector<Place>& places, std::vector<double> areas_m2) {
    const auto median = areas_m2.begin() + static_cast<std::ptrdiff_t>(areas_m2.size() / 2);
    std::nth_element(areas_m2.begin(), median, areas_m2.end());
    const double row_m = 0.75 * std::sqrt(*median);
    const auto is_higher = [](const Place& p, const Place& q) {
        return std::pair{p.at.y, p.at.x} < std::pair{q.at.y, q.at.x};
    };
    const auto is_left = [](const Place& p, const Place& q) {
        return std::pair{p.at.x, p.at.y} < std::pair{q.at.x, q.at.y};
    };
    std::sort(places.begin(), places.end(), is_higher);
    for (auto row = places.begin(); row != places.end();) {
        const double end_y = row->at.y + row_m;
        const auto next = std::find_if(row, places.end(),
                                       [&](const Place& place) { return place.at.y >= end_y; });
        std::sort(row, next, is_left);
        row = next;
    }
}

/// The number of each room, 1 .. n. Those of glimpses follow those of rooms.
std::vector<std::uint32_t> reading_order(const Segmentation& result, const GridMap& map) {
    std::vector<std::uint32_t> number(result.rooms.size() + 1, 0);
    std::uint32_t count = 0;
    for (const bool are_glimpses : {false, true}) {
        std::vector<Place> places;
        std::vector<double> areas_m2;
        for (const Room& room : result.rooms) {
            if ((room.seen == Seen::glimpse) != are_glimpses) continue;
            places.push_back(
                {place_on_page(room, result.labels, map), static_cast<std::uint32_t>(room.id)});
            areas_m2.push_back(room.area_m2);
        }
        if (places.empty()) continue;
        put_in_reading_order(places, std::move(areas_m2));
        for (const Place& place : places) number[place.label] = ++count;
    }
    return number;
}

}  // namespace

std::uint32_t number_by_first_cells(Raster<std::uint32_t>& labels, const Layout& layout,
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

void number_in_reading_order(Segmentation& result, const GridMap& map, const Executor& executor) {
    const std::vector<std::uint32_t> number = reading_order(result, map);
    renumber(result.labels, number, executor);
    for (Room& room : result.rooms) {
        room.id = RoomId{number[index(room.id)]};
        room.name = default_name(room);
    }
    std::sort(result.rooms.begin(), result.rooms.end(),
              [](const Room& p, const Room& q) { return p.id < q.id; });
    for (Door& door : result.doors) {
        door.a = RoomId{number[index(door.a)]};
        door.b = RoomId{number[index(door.b)]};
        if (door.a < door.b) continue;
        std::swap(door.a, door.b);
        std::swap(door.room_a_width_m, door.room_b_width_m);
    }
    std::stable_sort(result.doors.begin(), result.doors.end(), [](const Door& p, const Door& q) {
        return std::pair{p.a, p.b} < std::pair{q.a, q.b};
    });
}

}  // namespace quadcut
