// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/closure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

constexpr double kNearRoomM = 0.5;

/// The middles of the cells of a border, by the room on this side and the room beyond.
using Borders = std::map<std::pair<std::uint16_t, std::uint16_t>, std::vector<Point>>;

Borders find_borders(const Raster<std::uint16_t>& labels) {
    Borders borders;
    const auto note = [&](Cell cell, Cell next) {
        if (!labels.contains(next)) return;
        const std::uint16_t here = labels.at(cell);
        const std::uint16_t there = labels.at(next);
        if (here == 0 || there == 0 || here == there) return;
        const Point middle{(cell.x + next.x + 1) / 2.0, (cell.y + next.y + 1) / 2.0};
        borders[{here, there}].push_back(middle);
        borders[{there, here}].push_back(middle);
    };
    for_each_cell(labels.box(), [&](Cell cell) {
        note(cell, {cell.x + 1, cell.y});
        note(cell, {cell.x, cell.y + 1});
    });
    return borders;
}

double nearest(const std::vector<Point>& border, const Point& at) {
    double least = std::numeric_limits<double>::infinity();
    for (const Point& point : border) least = std::min(least, distance(point, at));
    return least;
}

}  // namespace

ClosureIndex::ClosureIndex(const GridMap& frame, const Segmentation& rooms,
                           const ClosureOptions& options)
    : frame_(frame),
      rooms_(rooms),
      options_(options),
      openings_(rooms.rooms.size() + 1),
      poses_in_(rooms.rooms.size() + 1) {
    for (auto& [pair, border] : find_borders(rooms.labels)) {
        openings_[pair.first].push_back({pair.second, std::move(border)});
    }
}

std::uint16_t ClosureIndex::room_near(const Point& at) const {
    const Raster<std::uint16_t>& labels = rooms_.labels;
    const Cell cell = cell_of(at);
    if (labels.contains(cell) && labels.at(cell) != 0) return labels.at(cell);
    double least = kNearRoomM / frame_.resolution_m;
    std::uint16_t room = 0;
    const Box around = Box{cell, cell}.grown(static_cast<std::int32_t>(least) + 1);
    for_each_cell(around.intersected(labels.box()), [&](Cell next) {
        const double away = distance({next.x + 0.5, next.y + 0.5}, at);
        if (labels.at(next) == 0 || away > least) return;
        least = away;
        room = labels.at(next);
    });
    return room;
}

std::size_t ClosureIndex::add(const Point& pose) {
    const Point in_map = transform(inverse(frame_.map_from_image), pose);
    Placed placed;
    placed.at = {in_map.x / frame_.resolution_m, in_map.y / frame_.resolution_m};
    placed.room = room_near(placed.at);
    if (!poses_.empty()) {
        const Placed& last = poses_.back();
        placed.way_m = last.way_m + distance(last.at, placed.at) * frame_.resolution_m;
    }
    for (const Opening& opening : openings_[placed.room]) {
        placed.opening_m.push_back(
            static_cast<float>(nearest(opening.border, placed.at) * frame_.resolution_m));
    }
    poses_in_[placed.room].push_back(poses_.size());
    poses_.push_back(std::move(placed));
    return poses_.size() - 1;
}

bool ClosureIndex::is_worth(const Placed& earlier, const Placed& later) const {
    return later.way_m - earlier.way_m >= options_.least_way_m &&
           distance(earlier.at, later.at) * frame_.resolution_m <= options_.range_m;
}

std::vector<std::size_t> ClosureIndex::candidates(std::size_t pose) const {
    const Placed& later = poses_[pose];
    std::vector<std::size_t> found;
    const auto look_in = [&](std::uint16_t room, const auto& is_near) {
        for (const std::size_t i : poses_in_[room]) {
            if (i >= pose) break;
            if (is_worth(poses_[i], later) && is_near(poses_[i])) found.push_back(i);
        }
    };
    const auto always = [](const Placed&) { return true; };
    if (later.room == 0) {
        for (std::size_t room = 0; room < poses_in_.size(); ++room) {
            look_in(static_cast<std::uint16_t>(room), always);
        }
    } else {
        look_in(0, always);
        look_in(later.room, always);
        for (std::size_t i = 0; i < openings_[later.room].size(); ++i) {
            const std::uint16_t beyond = openings_[later.room][i].room;
            const double here_m = static_cast<double>(later.opening_m[i]);
            if (here_m > options_.through_opening_m) continue;
            const auto& back = openings_[beyond];
            const auto same = std::find_if(back.begin(), back.end(), [&](const Opening& opening) {
                return opening.room == later.room;
            });
            const auto place = static_cast<std::size_t>(same - back.begin());
            look_in(beyond, [&](const Placed& earlier) {
                const double there_m = static_cast<double>(earlier.opening_m[place]);
                return here_m + there_m <= options_.through_opening_m;
            });
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace quadcut
