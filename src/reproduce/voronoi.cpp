// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/voronoi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace quadcut::reproduce {
namespace {

constexpr std::array<Cell, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
constexpr std::array<Cell, 8> kAround{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

std::int64_t squared_distance(Cell a, Cell b) {
    const std::int64_t dx = std::int64_t{a.x} - b.x;
    const std::int64_t dy = std::int64_t{a.y} - b.y;
    return dx * dx + dy * dy;
}

Cell moved(Cell cell, Cell step) { return {cell.x + step.x, cell.y + step.y}; }

/// The nearest obstacle of each open cell, and how far it is, cells.
struct Nearest {
    Raster<Cell> obstacle;
    Raster<float> distance;
};

/// Obstacles spread to their neighbours, nearest first: exact but for rare cells whose nearest
/// obstacle reaches none of their neighbours.
Nearest spread_obstacles(const Raster<std::uint8_t>& open) {
    constexpr float kFar = 1e9F;
    Nearest nearest{Raster<Cell>(open.origin, open.width, open.height),
                    Raster<float>(open.origin, open.width, open.height, kFar)};
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    const auto offer = [&](Cell cell, Cell obstacle) {
        if (!open.contains(cell)) return;
        const auto distance =
            static_cast<float>(std::sqrt(static_cast<double>(squared_distance(cell, obstacle))));
        if (distance >= nearest.distance.at(cell)) return;
        nearest.distance.at(cell) = distance;
        nearest.obstacle.at(cell) = obstacle;
        waiting.emplace(distance, open.offset(cell));
    };
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        const Cell cell = open.cell(i);
        if (open.values[i] == 0) offer(cell, cell);
        // What lies beyond the map blocks.
        for (const Cell step : kSteps) {
            if (!open.contains(moved(cell, step))) offer(cell, moved(cell, step));
        }
    }
    while (!waiting.empty()) {
        const auto [distance, place] = waiting.top();
        waiting.pop();
        if (distance > nearest.distance.values[place]) continue;
        const Cell cell = open.cell(place);
        for (const Cell step : kAround) offer(moved(cell, step), nearest.obstacle.at(cell));
    }
    return nearest;
}

/// The open cells beside which another obstacle is nearest, seen at more than 100 degrees from the
/// first: the middle between two walls, not the bisector of a corner or of a wall's own bumps.
std::vector<Cell> graph_cells(const Raster<std::uint8_t>& open, const Nearest& nearest,
                              double min_clearance) {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        const double distance = nearest.distance.values[i];
        if (open.values[i] == 0 || distance < min_clearance) continue;
        const Cell cell = open.cell(i);
        for (const Cell step : {kSteps[0], kSteps[1]}) {
            const Cell beside = moved(cell, step);
            if (!open.contains(beside) || open.at(beside) == 0) continue;
            const auto apart = static_cast<double>(
                squared_distance(nearest.obstacle.at(cell), nearest.obstacle.at(beside)));
            if (apart > 2.4 * distance * distance) {
                cells.push_back(cell);
                break;
            }
        }
    }
    return cells;
}

/// The cells of the graph within a radius of one of its cells that it leads to; gaps of one cell
/// are stepped over.
void walk_graph(const Raster<std::uint8_t>& is_graph, Cell from, std::int32_t radius,
                std::vector<Cell>& met, Raster<std::uint32_t>& met_by, std::uint32_t walk) {
    met = {from};
    met_by.at(from) = walk;
    for (std::size_t i = 0; i < met.size(); ++i) {
        for (std::int32_t dy = -2; dy <= 2; ++dy) {
            for (std::int32_t dx = -2; dx <= 2; ++dx) {
                const Cell next = moved(met[i], {dx, dy});
                if (!is_graph.contains(next) || is_graph.at(next) == 0) continue;
                if (met_by.at(next) == walk) continue;
                if (squared_distance(next, from) > std::int64_t{radius} * radius) continue;
                met_by.at(next) = walk;
                met.push_back(next);
            }
        }
    }
}

/// Where the graph is narrowest within the radius, and wider on two sides of the place.
std::vector<Cell> critical_cells(const std::vector<Cell>& graph, const Nearest& nearest,
                                 double resolution_m, const VoronoiOptions& options) {
    const Box box = nearest.distance.box();
    Raster<std::uint8_t> is_graph(box);
    Raster<std::uint32_t> met_by(box);
    for (const Cell cell : graph) is_graph.at(cell) = 1;
    const auto radius = static_cast<std::int32_t>(options.critical_radius_m / resolution_m);
    const double max_distance = options.max_clearance_m / resolution_m;
    std::vector<Cell> critical;
    std::vector<Cell> met;
    std::uint32_t walk = 0;
    for (const Cell cell : graph) {
        const float own = nearest.distance.at(cell);
        if (own > max_distance) continue;
        walk_graph(is_graph, cell, radius, met, met_by, ++walk);
        const Cell wall = nearest.obstacle.at(cell);
        bool is_least = true;
        // The widest place on either side of the line to the nearest obstacle.
        std::array<float, 2> widest{0.0F, 0.0F};
        for (const Cell other : met) {
            const float distance = nearest.distance.at(other);
            // Of equal ones the first in reading order.
            const bool is_before = other.y < cell.y || (other.y == cell.y && other.x < cell.x);
            is_least = is_least && (distance > own || (distance == own && !is_before));
            const std::int64_t turn = std::int64_t{wall.x - cell.x} * (other.y - cell.y) -
                                      std::int64_t{wall.y - cell.y} * (other.x - cell.x);
            if (turn == 0) continue;
            float& side = widest[turn > 0 ? 1 : 0];
            side = std::max(side, distance);
        }
        const auto needed = static_cast<float>(options.min_widening) * own;
        if (is_least && widest[0] >= needed && widest[1] >= needed) critical.push_back(cell);
    }
    return critical;
}

/// The nearest obstacle on the other side than the nearest one.
Cell opposite_obstacle(Cell cell, const Nearest& nearest) {
    const Cell first = nearest.obstacle.at(cell);
    Cell best = first;
    double least = 1e18;
    for (std::int32_t dy = -2; dy <= 2; ++dy) {
        for (std::int32_t dx = -2; dx <= 2; ++dx) {
            const Cell beside{cell.x + dx, cell.y + dy};
            if (!nearest.distance.contains(beside)) continue;
            const Cell obstacle = nearest.obstacle.at(beside);
            const auto dot = std::int64_t{obstacle.x - cell.x} * (first.x - cell.x) +
                             std::int64_t{obstacle.y - cell.y} * (first.y - cell.y);
            const auto distance = static_cast<double>(squared_distance(obstacle, cell));
            if (dot < 0 && distance < least) {
                least = distance;
                best = obstacle;
            }
        }
    }
    return best;
}

/// Closes the cells between two cells, so that no step of one cell crosses the line.
void close_line(Raster<std::uint8_t>& open, Cell from, Cell to) {
    const std::int32_t steps = 2 * std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), 1});
    Cell last = from;
    for (std::int32_t i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const Cell cell{static_cast<std::int32_t>(std::lround(from.x + share * (to.x - from.x))),
                        static_cast<std::int32_t>(std::lround(from.y + share * (to.y - from.y)))};
        for (const Cell closed : {cell, Cell{cell.x, last.y}}) {
            if (open.contains(closed)) open.at(closed) = 0;
        }
        last = cell;
    }
}

/// Numbers what is connected; then what was closed joins the region that reaches it first.
std::uint32_t label_parts(const Raster<std::uint8_t>& open, const Raster<std::uint8_t>& parted,
                          Raster<std::uint32_t>& labels) {
    std::uint32_t count = 0;
    std::vector<Cell> edge;
    for (std::size_t i = 0; i < parted.values.size(); ++i) {
        if (parted.values[i] == 0 || labels.values[i] != 0) continue;
        std::vector<Cell> waiting{parted.cell(i)};
        labels.values[i] = ++count;
        while (!waiting.empty()) {
            const Cell cell = waiting.back();
            waiting.pop_back();
            edge.push_back(cell);
            for (const Cell step : kSteps) {
                const Cell next = moved(cell, step);
                if (!parted.contains(next) || parted.at(next) == 0 || labels.at(next) != 0)
                    continue;
                labels.at(next) = count;
                waiting.push_back(next);
            }
        }
    }
    for (std::size_t i = 0; i < edge.size(); ++i) {
        for (const Cell step : kSteps) {
            const Cell next = moved(edge[i], step);
            if (!open.contains(next) || open.at(next) == 0 || labels.at(next) != 0) continue;
            labels.at(next) = labels.at(edge[i]);
            edge.push_back(next);
        }
    }
    return count;
}

/// The smallest region first joins the neighbour with the longest common border. Regions that
/// touch none stay; returns what each region became, 0 where it is too small and alone.
std::vector<std::uint32_t> merge_small(const Raster<std::uint32_t>& labels, std::uint32_t count,
                                       double min_cells) {
    std::vector<std::size_t> cells(count + 1, 0);
    std::vector<std::map<std::uint32_t, std::size_t>> borders(count + 1);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const std::uint32_t a = labels.values[i];
        if (a == 0) continue;
        ++cells[a];
        for (const Cell step : {kSteps[0], kSteps[1]}) {
            const Cell beside = moved(labels.cell(i), step);
            const std::uint32_t b = labels.contains(beside) ? labels.at(beside) : 0;
            if (b == 0 || b == a) continue;
            ++borders[a][b];
            ++borders[b][a];
        }
    }
    std::vector<std::uint32_t> became(count + 1);
    for (std::uint32_t i = 0; i <= count; ++i) became[i] = i;
    std::vector<std::uint32_t> order(became.begin() + 1, became.end());
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(cells[a], a) < std::pair(cells[b], b);
    });
    for (const std::uint32_t small : order) {
        if (static_cast<double>(cells[small]) >= min_cells) continue;
        std::uint32_t into = 0;
        std::size_t longest = 0;
        for (const auto& [other, length] : borders[small]) {
            if (length > longest) {
                longest = length;
                into = other;
            }
        }
        became[small] = into;
        if (into == 0) continue;
        cells[into] += cells[small];
        for (const auto& [other, length] : borders[small]) {
            borders[other].erase(small);
            if (other == into) continue;
            borders[into][other] += length;
            borders[other][into] += length;
        }
        borders[small].clear();
    }
    for (std::uint32_t& label : became) {
        while (became[label] != label) label = became[label];
    }
    return became;
}

}  // namespace

VoronoiRegions voronoi_regions(const Raster<std::uint8_t>& open, double resolution_m,
                               const VoronoiOptions& options) {
    VoronoiRegions result;
    result.regions = Raster<std::uint32_t>(open.origin, open.width, open.height);
    const Nearest nearest = spread_obstacles(open);
    const std::vector<Cell> graph =
        graph_cells(open, nearest, options.min_clearance_m / resolution_m);
    const std::vector<Cell> critical = critical_cells(graph, nearest, resolution_m, options);
    result.num_graph_cells = graph.size();
    result.num_critical = critical.size();
    Raster<std::uint8_t> parted = open;
    for (const Cell cell : critical) {
        close_line(parted, cell, nearest.obstacle.at(cell));
        close_line(parted, cell, opposite_obstacle(cell, nearest));
    }
    const std::uint32_t count = label_parts(open, parted, result.regions);
    const std::vector<std::uint32_t> became =
        merge_small(result.regions, count, options.min_region_m2 / (resolution_m * resolution_m));
    std::vector<std::uint32_t> number(count + 1, 0);
    for (std::uint32_t label = 1; label <= count; ++label) {
        if (became[label] == label) number[label] = ++result.num_regions;
    }
    for (std::uint32_t& label : result.regions.values) label = number[became[label]];
    return result;
}

}  // namespace quadcut::reproduce
