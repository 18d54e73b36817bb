// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/inside.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace quadcut {
namespace {

/// A building fills at least this much of the ground around it; less are things inside of one.
constexpr double kMinBuildingShare = 0.05;

/// Of each part, on the border of the raster.
std::vector<std::uint32_t> num_border_cells(const ConnectedParts& parts) {
    std::vector<std::uint32_t> result(parts.count + std::size_t{1}, 0);
    const auto width = static_cast<std::size_t>(parts.width);
    const std::size_t last_row = width * (parts.row_begin.size() - 2);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        const bool is_edge_row = first < width || first >= last_row;
        const std::uint32_t num_ends =
            (run.begin == 0 ? 1U : 0U) + (run.end == width && width > 1 ? 1U : 0U);
        result[run.part] += is_edge_row ? run.end - run.begin : num_ends;
    });
    return result;
}

/// The border of a box, once around. @pre at least two cells each way.
std::vector<Cell> border_of(const Box& box) {
    std::vector<Cell> border;
    for (std::int32_t x = box.low.x; x < box.high.x; ++x) border.push_back({x, box.low.y});
    for (std::int32_t y = box.low.y; y < box.high.y; ++y) border.push_back({box.high.x, y});
    for (std::int32_t x = box.high.x; x > box.low.x; --x) border.push_back({x, box.high.y});
    for (std::int32_t y = box.high.y; y > box.low.y; --y) border.push_back({box.low.x, y});
    return border;
}

/// The labels of the longest stretch without a 0 of what goes around, where that is more than half.
std::set<std::uint32_t> labels_around(const std::vector<std::uint32_t>& around) {
    const std::size_t length = around.size();
    std::size_t begin = 0;
    // Twice around: a stretch may go on over the first one.
    for (std::size_t i = 0; i < 2 * length; ++i) {
        if (around[i % length] == 0) begin = i + 1;
        const std::size_t stretch = i + 1 - begin;
        if (2 * stretch <= length) continue;
        std::size_t end = i + 1;
        while (end < begin + length && around[end % length] != 0) ++end;
        std::set<std::uint32_t> labels;
        for (; begin < end; ++begin) labels.insert(around[begin % length]);
        return labels;
    }
    return {};
}

}  // namespace

Raster<std::uint8_t> mask_of(const GridMap& map, CellState state) {
    Raster<std::uint8_t> mask(map.states.origin, map.states.width, map.states.height);
    std::transform(
        map.states.values.begin(), map.states.values.end(), mask.values.begin(),
        [state](CellState own) { return own == state ? std::uint8_t{1} : std::uint8_t{0}; });
    return mask;
}

std::vector<Cell> visited_cells(const GridMap& map, std::span<const Point> trajectory) {
    const Pose image_from_map = inverse(map.map_from_image);
    std::vector<Cell> cells;
    for (const Point& point : trajectory) {
        const Point at = transform(image_from_map, point);
        const double x = std::floor(at.x / map.resolution_m);
        const double y = std::floor(at.y / map.resolution_m);
        if (!(std::abs(x) < 1e9 && std::abs(y) < 1e9)) continue;
        const Cell cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
        if (map.states.contains(cell)) cells.push_back(cell);
    }
    return cells;
}

void drop_uncrossed(Raster<std::uint32_t>& labels, std::span<const Cell> way) {
    if (way.empty() || labels.values.empty()) return;
    const std::uint32_t last = *std::max_element(labels.values.begin(), labels.values.end());
    std::vector<bool> is_crossed(last + std::size_t{1}, false);
    for (const Cell cell : way) {
        if (labels.contains(cell)) is_crossed[labels.at(cell)] = true;
    }
    for (std::uint32_t& label : labels.values) {
        if (!is_crossed[label]) label = 0;
    }
}

std::uint32_t find_outside(const ConnectedParts& free, std::size_t min_cells) {
    const auto width = static_cast<std::size_t>(free.width);
    const std::size_t height = free.row_begin.size() - 1;
    const std::size_t border =
        width < 2 || height < 2 ? width * height : 2 * width + 2 * height - 4;
    const std::vector<std::size_t> num_cells = free.num_cells();
    const std::vector<std::uint32_t> num_border = num_border_cells(free);
    std::uint32_t outside = 0;
    std::size_t num_others = 0;
    for (std::uint32_t part = 1; part <= free.count; ++part) {
        if (2 * std::size_t{num_border[part]} > border) {
            outside = part;
        } else if (num_cells[part] >= min_cells) {
            num_others += num_cells[part];
        }
    }
    const bool is_building = static_cast<double>(num_others) <
                             kMinBuildingShare * static_cast<double>(num_cells[outside]);
    return is_building ? 0 : outside;
}

Raster<std::uint8_t> inside(const GridMap& map, std::span<const Point> trajectory,
                            double min_area_m2, const Executor& executor) {
    const ConnectedParts free = free_parts(map.states, executor);
    const double min_cells = min_area_m2 / (map.resolution_m * map.resolution_m);
    std::vector<std::uint8_t> kept;
    for (const std::size_t num_cells : free.num_cells()) {
        kept.push_back(num_cells > 0 && static_cast<double>(num_cells) >= min_cells ? 1 : 0);
    }
    const std::uint32_t outside =
        find_outside(free, static_cast<std::size_t>(std::ceil(min_cells)));
    const std::vector<Cell> visited = visited_cells(map, trajectory);
    const Cell origin = map.states.origin;
    const bool is_entered = std::any_of(visited.begin(), visited.end(), [&](Cell cell) {
        return free.part_at(static_cast<std::uint32_t>(cell.x - origin.x),
                            static_cast<std::size_t>(cell.y - origin.y)) == outside;
    });
    if (!is_entered) kept[outside] = 0;
    auto mask = Raster<std::uint8_t>::unset(map.states.box());
    free.paint(kept, mask, executor);
    return mask;
}

void drop_outside(Raster<std::uint32_t>& labels, const Layout& layout, const Box& box,
                  std::span<const Cell> way) {
    if (box.width() < 2 || box.height() < 2) return;
    std::vector<std::uint32_t> around;
    for (const Cell cell : border_of(box)) {
        const Cell place = layout.place_of(cell);
        around.push_back(labels.contains(place) ? labels.at(place) : 0);
    }
    std::set<std::uint32_t> outside = labels_around(around);
    for (const Cell cell : way) {
        if (labels.contains(cell)) outside.erase(labels.at(cell));
    }
    if (outside.empty()) return;
    std::vector<std::size_t> outer;
    std::size_t num_inside = 0;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (labels.values[i] == 0) continue;
        if (outside.count(labels.values[i]) != 0) {
            outer.push_back(i);
        } else {
            ++num_inside;
        }
    }
    if (static_cast<double>(num_inside) < kMinBuildingShare * static_cast<double>(outer.size())) {
        return;
    }
    for (const std::size_t i : outer) labels.values[i] = 0;
}

}  // namespace quadcut
