// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/map_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/canvas.hpp"
#include "draw/floor_plan.hpp"
#include "draw/render.hpp"
#include "draw/typeface.hpp"
#include "io/image.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/paper/line_of_sight.hpp"
#include "reproduce/plan_within.hpp"

namespace quadcut::reproduce {
namespace {

constexpr double kSide = 1100.0;
constexpr double kMargin = 8.0;
constexpr io::Rgb kFreeInk{0xEE, 0xF3, 0xF8};
constexpr io::Rgb kLeafInk{0x9D, 0xB0, 0xC4};
constexpr io::Rgb kEdgeInk{0x1F, 0x5F, 0xA8};
constexpr io::Rgb kLinkInk{0xD0, 0x21, 0x2E};

/// The known part of a map on a page.
class Page {
public:
    explicit Page(const GridMap& map) {
        for (std::size_t i = 0; i < map.states.values.size(); ++i) {
            if (map.states.values[i] == CellState::unknown) continue;
            const Cell cell = map.states.cell(i);
            known_.include({cell, cell});
        }
        if (known_.is_empty()) known_ = {{0, 0}, {0, 0}};
        scale_ = (kSide - 2.0 * kMargin) / std::max(known_.width(), known_.height());
        width_ = static_cast<std::int32_t>(std::ceil(known_.width() * scale_ + 2.0 * kMargin));
        height_ = static_cast<std::int32_t>(std::ceil(known_.height() * scale_ + 2.0 * kMargin));
    }

    [[nodiscard]] draw::Canvas canvas() const { return {width_, height_, draw::kPaper}; }
    /// Pixels a cell.
    [[nodiscard]] double scale() const { return scale_; }
    /// Where a corner of a cell is.
    [[nodiscard]] Point at(double x, double y) const {
        return {kMargin + (x - known_.low.x) * scale_, kMargin + (known_.high.y + 1 - y) * scale_};
    }

private:
    Box known_;
    double scale_ = 1.0;
    std::int32_t width_ = 1;
    std::int32_t height_ = 1;
};

std::array<Point, 4> square(const Page& page, const Leaf& leaf) {
    const Cell low = leaf.lower_left;
    const std::int32_t side = leaf.side_cells();
    return {page.at(low.x, low.y), page.at(low.x + side, low.y),
            page.at(low.x + side, low.y + side), page.at(low.x, low.y + side)};
}

}  // namespace

Picture plan_picture(std::string file, const GridMap& map, const Segmentation& rooms,
                     std::string caption, std::span<const std::pair<Point, Point>> links) {
    const draw::FloorPlan plan = plan_within(map, rooms, kSide, kSide);
    draw::Canvas canvas(plan.page_width, plan.page_height, draw::kPaper);
    draw::draw_plan(canvas, plan, draw::Typeface());
    const auto at = [&plan](const Point& cells) {
        const double half_cell = plan.pixels_per_half_cell;
        return Point{plan.drawing_origin.x + 2.0 * half_cell * (cells.x - plan.frame.low.x),
                     plan.drawing_origin.y + 2.0 * half_cell * (plan.frame.high.y + 1 - cells.y)};
    };
    draw::Shape lines;
    for (const auto& [from, to] : links) {
        const std::array<Point, 2> line{at(from), at(to)};
        lines.add_line(line, 3.0);
        for (const Point& end : line) lines.add_disc(end, 6.0);
    }
    canvas.fill(lines, kLinkInk, 0.85);
    return {std::move(file), canvas.encode_png(), std::move(caption)};
}

Picture quadtree_picture(std::string file, const GridMap& map, std::string caption) {
    const Page page(map);
    draw::Canvas canvas = page.canvas();
    draw::Shape free;
    draw::Shape occupied;
    draw::Shape outlines;
    const double width = std::clamp(0.12 * page.scale(), 0.25, 1.0);
    for (const Leaf& leaf : OccupancyMap::from_grid(map).leaves()) {
        if (leaf.state == CellState::unknown) continue;
        const std::array<Point, 4> corners = square(page, leaf);
        (leaf.state == CellState::free ? free : occupied).add_polygon(corners);
        if (leaf.state == CellState::free) outlines.add_closed_line(corners, width);
    }
    canvas.fill(free, kFreeInk);
    canvas.fill(outlines, kLeafInk);
    canvas.fill(occupied, draw::kWallInk);
    return {std::move(file), canvas.encode_png(), std::move(caption)};
}

Picture graph_picture(std::string file, const MapGraph& graph, const GridMap& map,
                      std::string caption) {
    const Page page(map);
    draw::Canvas canvas = page.canvas();
    draw::Shape occupied;
    for (const Leaf& leaf : graph.leaves.table.leaves()) {
        if (leaf.state == CellState::occupied) occupied.add_polygon(square(page, leaf));
    }
    canvas.fill(occupied, draw::kWallInk);
    const auto point_of = [&](std::size_t node) {
        const HalfCell at = centre(graph.leaves.table.leaf(graph.leaves.nodes[node]));
        return page.at(static_cast<double>(at.x) / 2.0, static_cast<double>(at.y) / 2.0);
    };
    draw::Shape edges;
    const double width = std::clamp(0.1 * page.scale(), 0.3, 1.0);
    for (std::size_t node = 0; node < graph.graph.num_nodes(); ++node) {
        for (const std::uint32_t other : graph.graph.neighbours(node)) {
            if (other <= node) continue;
            const std::array<Point, 2> line{point_of(node), point_of(other)};
            edges.add_line(line, width);
        }
    }
    canvas.fill(edges, kEdgeInk, 0.8);
    return {std::move(file), canvas.encode_png(), std::move(caption)};
}

Picture scans_picture(std::string file, std::span<const Scan> scans, const GridMap& map,
                      std::string caption) {
    const Page page(map);
    draw::Canvas canvas = page.canvas();
    const Pose image_from_map = inverse(map.map_from_image);
    const auto on_page = [&](const Point& at) {
        const Point in_image = transform(image_from_map, at);
        return page.at(in_image.x / map.resolution_m, in_image.y / map.resolution_m);
    };
    draw::Shape hits;
    std::vector<Point> way;
    for (const Scan& scan : scans) {
        const Pose& pose = scan.world_from_sensor;
        way.push_back(on_page({pose.x, pose.y}));
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            const auto range = static_cast<double>(scan.ranges_m[i]);
            if (!(range > 0.0) || range >= scan.max_range_m) continue;
            const double angle =
                pose.yaw_rad + scan.first_angle_rad + scan.angle_step_rad * static_cast<double>(i);
            const Point at =
                on_page({pose.x + range * std::cos(angle), pose.y + range * std::sin(angle)});
            const std::array<Point, 4> dot{{{at.x - 0.7, at.y - 0.7},
                                            {at.x + 0.7, at.y - 0.7},
                                            {at.x + 0.7, at.y + 0.7},
                                            {at.x - 0.7, at.y + 0.7}}};
            hits.add_polygon(dot);
        }
    }
    canvas.fill(hits, draw::kWallInk, 0.6);
    draw::Shape line;
    line.add_line(way, 2.0);
    canvas.fill(line, kEdgeInk);
    return {std::move(file), canvas.encode_png(), std::move(caption)};
}

Picture matrix_picture(std::string file, std::size_t size,
                       std::span<const std::pair<std::uint32_t, std::uint32_t>> entries,
                       std::string caption) {
    constexpr std::int32_t kPixels = 700;
    // Entries are counted by pixel, so that few show as well as many.
    std::vector<std::uint8_t> dark(static_cast<std::size_t>(kPixels) * kPixels, 0);
    const auto pixel = [size](std::uint32_t place) {
        return static_cast<std::size_t>(place) * kPixels / std::max<std::size_t>(1, size);
    };
    for (const auto& [a, b] : entries) {
        dark[pixel(a) * kPixels + pixel(b)] = 1;
        dark[pixel(b) * kPixels + pixel(a)] = 1;
    }
    const io::ImageHeader header{kPixels, kPixels, 1, 255};
    std::string png = io::encode_png(header, [&](std::int32_t y, std::span<std::uint16_t> samples) {
        for (std::size_t x = 0; x < samples.size(); ++x) {
            samples[x] = dark[static_cast<std::size_t>(y) * kPixels + x] != 0 ? 40 : 252;
        }
    });
    return {std::move(file), std::move(png), std::move(caption)};
}

std::vector<Point> middles_of(const Segmentation& rooms) {
    std::vector<Point> sums(rooms.rooms.size());
    std::vector<double> counts(rooms.rooms.size(), 0.0);
    for (std::size_t i = 0; i < rooms.labels.values.size(); ++i) {
        const std::uint16_t label = rooms.labels.values[i];
        if (label == 0) continue;
        const Cell cell = rooms.labels.cell(i);
        sums[label - 1U].x += cell.x + 0.5;
        sums[label - 1U].y += cell.y + 0.5;
        counts[label - 1U] += 1.0;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = {sums[i].x / std::max(1.0, counts[i]), sums[i].y / std::max(1.0, counts[i])};
    }
    return sums;
}

}  // namespace quadcut::reproduce
