// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/label_spots.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut::draw {
namespace {

constexpr std::size_t kMostSpots = 24;
/// Spots are so far apart, of the longer side of the room's box.
constexpr double kApart = 0.08;
/// Of large rooms not every cell is looked at.
constexpr double kMostSamples = 1 << 18;

struct Spot {
    float depth = 0.0F;
    Cell sample;
};

/// 1 where the sample of the room's box is of the room.
Raster<std::uint8_t> sample_room(const Raster<std::uint16_t>& ground, std::uint16_t room,
                                 const Box& box, std::int32_t stride) {
    Raster<std::uint8_t> is_room({0, 0}, (box.width() - 1) / stride + 1,
                                 (box.height() - 1) / stride + 1);
    const auto width = static_cast<std::size_t>(ground.width);
    for (std::size_t i = 0; i < is_room.values.size(); ++i) {
        const Cell sample = is_room.cell(i);
        const auto x = static_cast<std::size_t>(box.low.x + stride * sample.x);
        const auto y = static_cast<std::size_t>(box.low.y + stride * sample.y);
        is_room.values[i] = ground.values[y * width + x] == room ? 1 : 0;
    }
    return is_room;
}

/// What is not nearer to the border than its four neighbours, the deepest first.
std::vector<Spot> ridge_of(const Raster<float>& depth) {
    std::vector<Spot> ridge;
    const auto at = [&](Cell cell) { return depth.contains(cell) ? depth.at(cell) : 0.0F; };
    for (std::size_t i = 0; i < depth.values.size(); ++i) {
        const float own = depth.values[i];
        if (own <= 0.0F) continue;
        const Cell cell = depth.cell(i);
        const bool is_top_x = own >= at({cell.x - 1, cell.y}) && own >= at({cell.x + 1, cell.y});
        const bool is_top_y = own >= at({cell.x, cell.y - 1}) && own >= at({cell.x, cell.y + 1});
        if (is_top_x && is_top_y) ridge.push_back({own, cell});
    }
    std::stable_sort(ridge.begin(), ridge.end(),
                     [](const Spot& p, const Spot& q) { return p.depth > q.depth; });
    return ridge;
}

std::vector<Point> spots_in(const Raster<std::uint16_t>& ground, std::uint16_t room,
                            const Box& box) {
    if (box.is_empty()) return {};
    const double num_cells = static_cast<double>(box.width()) * box.height();
    const auto stride =
        static_cast<std::int32_t>(std::max(std::ceil(std::sqrt(num_cells / kMostSamples)), 1.0));
    const Raster<float> depth = clearance_m(sample_room(ground, room, box, stride), 1.0);
    const double apart = kApart * std::max(depth.width, depth.height);
    std::vector<Spot> chosen;
    for (const Spot& spot : ridge_of(depth)) {
        if (chosen.size() == kMostSpots) break;
        const bool is_apart = std::all_of(chosen.begin(), chosen.end(), [&](const Spot& other) {
            return std::hypot(spot.sample.x - other.sample.x, spot.sample.y - other.sample.y) >=
                   apart;
        });
        if (is_apart) chosen.push_back(spot);
    }
    std::vector<Point> spots;
    for (const Spot& spot : chosen) {
        spots.push_back({ground.origin.x + box.low.x + stride * spot.sample.x + 0.5,
                         ground.origin.y + box.low.y + stride * spot.sample.y + 0.5});
    }
    return spots;
}

}  // namespace

std::vector<std::vector<Point>> find_label_spots(const Raster<std::uint16_t>& ground,
                                                 const std::vector<std::uint16_t>& rooms,
                                                 const Executor& executor) {
    if (rooms.empty()) return {};
    std::vector<Box> boxes = tally_by_label<Box>(
        ground, executor,
        [](Box& box, const LabelRun& run) {
            const auto y = static_cast<std::int32_t>(run.y);
            box.include({{static_cast<std::int32_t>(run.x), y},
                         {static_cast<std::int32_t>(run.x + run.num_cells - 1), y}});
        },
        [](Box& into, const Box& other) {
            if (!other.is_empty()) into.include(other);
        });
    std::vector<std::vector<Point>> spots(rooms.size());
    parallel_for(executor, rooms.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (rooms[i] < boxes.size()) spots[i] = spots_in(ground, rooms[i], boxes[rooms[i]]);
        }
    });
    return spots;
}

}  // namespace quadcut::draw
