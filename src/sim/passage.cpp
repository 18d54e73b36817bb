// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/passage.hpp"

#include <algorithm>
#include <cmath>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/flood.hpp"

namespace quadcut::sim {
namespace {

constexpr std::uint8_t kBlocked = 0;
constexpr std::uint8_t kOpen = 1;
constexpr std::uint8_t kUnderFurniture = 2;
constexpr std::uint8_t kReached = 3;

void paint(Raster<std::uint8_t>& raster, const std::vector<Span>& spans, std::uint8_t value) {
    for (const Span& span : spans) {
        std::uint8_t* cells = &raster.at(span.first);
        for (std::int32_t i = 0; i < span.count; ++i) {
            if (cells[i] != kBlocked) cells[i] = value;
        }
    }
}

}  // namespace

Passage::Passage(const Raster<std::uint16_t>& labels, const CellGrid& grid, std::uint16_t room,
                 const Rect& window, std::vector<Point> starts)
    : starts_(std::move(starts)) {
    Cell low = grid.cell({window.x0, window.y0});
    Cell high = grid.cell({window.x1, window.y1});
    low = {std::max(0, low.x), std::max(0, low.y)};
    high = {std::min(grid.width - 1, high.x), std::min(grid.height - 1, high.y)};
    const std::int32_t width = high.x - low.x + 1;
    const std::int32_t height = high.y - low.y + 1;
    grid_ = {{grid.origin.x + low.x * grid.resolution_m, grid.origin.y + low.y * grid.resolution_m},
             grid.resolution_m,
             width,
             height};
    Raster<std::uint8_t> floor({0, 0}, width, height);
    open_ = floor;
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) {
            const std::uint16_t label = labels.at({low.x + x, low.y + y});
            floor.at({x, y}) = label != 0 ? 1 : 0;
            open_.at({x, y}) = label == room ? kOpen : kBlocked;
        }
    }
    const Raster<float> clearance = clearance_m(floor, grid.resolution_m);
    for (std::size_t i = 0; i < open_.values.size(); ++i) {
        if (clearance.values[i] < static_cast<float>(kRobotRadius)) open_.values[i] = kBlocked;
        num_open_ += open_.values[i];
    }
}

bool Passage::is_open(const std::vector<Obstacle>& obstacles,
                      const std::vector<Polygon>& footprints) const {
    Raster<std::uint8_t> state = open_;
    for (const Polygon& footprint : footprints) {
        paint(state, rasterise(grow(footprint, 0.15), grid_), kUnderFurniture);
    }
    // Half a cell more than the radius: a cell counts when its whole square is free.
    const double reach = kRobotRadius + 0.5 * grid_.resolution_m;
    for (const Obstacle& obstacle : obstacles) {
        const std::vector<Span> spans =
            obstacle.box.empty() ? rasterise_disc(obstacle.center, obstacle.radius_m + reach, grid_)
                                 : rasterise(grow(obstacle.box, reach), grid_);
        paint(state, spans, kBlocked);
    }
    if (!starts_.empty() && num_open_ > 0) {
        const Cell first = grid_.cell(starts_.front());
        if (!state.contains(first) || state.at(first) == kBlocked) return false;
        std::vector<bool> seen(state.values.size(), false);
        const auto is_way = [&](std::size_t i) { return state.values[i] != kBlocked; };
        for (const std::size_t i :
             flood(state, state.offset(first), seen, Connectivity::four, is_way)) {
            state.values[i] = kReached;
        }
    }
    for (const Point& start : starts_) {
        const Cell cell = grid_.cell(start);
        if (!state.contains(cell) || state.at(cell) != kReached) return false;
    }
    const auto lost = std::count(state.values.begin(), state.values.end(), kOpen);
    const double cell_area = grid_.resolution_m * grid_.resolution_m;
    return static_cast<double>(lost) * cell_area <
           0.2 + 0.02 * static_cast<double>(num_open_) * cell_area;
}

}  // namespace quadcut::sim
