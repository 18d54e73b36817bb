// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/canvas.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "io/image.hpp"

namespace quadcut::io {
namespace {

/// The coverage of one row of pixels, as differences along the row: an edge adds to the pixels it
/// crosses, and every pixel to its right inherits the sum. Few pixels of a row differ from the one
/// before, so these are marked, and the rest is painted in spans.
class CoverageRow {
public:
    explicit CoverageRow(std::int32_t width)
        : width_(width),
          difference_(static_cast<std::size_t>(width), 0.0F),
          changed_(static_cast<std::size_t>(width) / kBitsPerWord + 1, 0) {}

    /// The part of an edge within this row: x at its upper and lower end, and its height (0..1)
    /// with the winding's sign.
    void add(float x_top, float x_bottom, float height) {
        const auto limit = static_cast<float>(width_);
        const float left = std::clamp(std::min(x_top, x_bottom), 0.0F, limit);
        const float right = std::clamp(std::max(x_top, x_bottom), 0.0F, limit);
        const auto first = static_cast<std::int32_t>(left);
        const auto last = static_cast<std::int32_t>(right);
        if (first == last) {
            // The pixel's share to the right of the edge is a trapezoid; those beyond are covered.
            const float inside = static_cast<float>(first) + 1.0F - 0.5F * (left + right);
            add_at(first, height * inside);
            add_at(first + 1, height * (1.0F - inside));
            return;
        }
        const float per_pixel = height / (right - left);
        float covered = 0.0F;
        float previous = 0.0F;
        for (std::int32_t x = first; x <= last; ++x) {
            const float from = std::max(left, static_cast<float>(x));
            const float to = std::min(right, static_cast<float>(x) + 1.0F);
            const float crossed = per_pixel * (to - from);
            const float inside =
                covered + crossed * (static_cast<float>(x) + 1.0F - 0.5F * (from + to));
            add_at(x, inside - previous);
            previous = inside;
            covered += crossed;
        }
        add_at(last + 1, height - previous);
    }

    /// Calls `paint(first, last, coverage)` for each span first .. last - 1 that is covered, and
    /// clears the row.
    template <typename Paint>
    void flush(const Paint& paint) {
        constexpr float kLeast = 1.0F / 512.0F;
        float coverage = 0.0F;
        float sum = 0.0F;
        std::int32_t span_begin = 0;
        for (std::size_t word = 0; word < changed_.size(); ++word) {
            for (; changed_[word] != 0; changed_[word] &= changed_[word] - 1) {
                const auto x = static_cast<std::int32_t>(
                    word * kBitsPerWord +
                    static_cast<std::size_t>(std::countr_zero(changed_[word])));
                if (coverage > kLeast) paint(span_begin, x, coverage);
                float& step = difference_[static_cast<std::size_t>(x)];
                sum += step;
                step = 0.0F;
                coverage = std::min(std::abs(sum), 1.0F);
                span_begin = x;
            }
        }
        if (coverage > kLeast) paint(span_begin, width_, coverage);
    }

private:
    void add_at(std::int32_t x, float value) {
        if (x >= width_) return;
        difference_[static_cast<std::size_t>(x)] += value;
        changed_[static_cast<std::size_t>(x) / kBitsPerWord] |=
            std::uint64_t{1} << (static_cast<std::size_t>(x) % kBitsPerWord);
    }

    static constexpr std::size_t kBitsPerWord = 64;

    std::int32_t width_;
    std::vector<float> difference_;
    /// A bit for each pixel: whether its difference was changed.
    std::vector<std::uint64_t> changed_;
};

Rgb blended(Rgb under, Rgb over, float share) {
    const auto channel = [share](std::uint8_t below, std::uint8_t above) {
        const float level = static_cast<float>(below) +
                            share * (static_cast<float>(above) - static_cast<float>(below));
        return static_cast<std::uint8_t>(std::lround(level));
    };
    return {channel(under.red, over.red), channel(under.green, over.green),
            channel(under.blue, over.blue)};
}

}  // namespace

void Shape::add_edge(Point from, Point to) {
    const auto x0 = static_cast<float>(from.x);
    const auto y0 = static_cast<float>(from.y);
    const auto x1 = static_cast<float>(to.x);
    const auto y1 = static_cast<float>(to.y);
    if (y0 < y1) edges_.push_back({x0, y0, x1, y1, 1.0F});
    if (y1 < y0) edges_.push_back({x1, y1, x0, y0, -1.0F});
}

void Shape::add_polygon(std::span<const Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        add_edge(points[i], points[(i + 1) % points.size()]);
    }
}

void Shape::add_disc(Point center, double radius) {
    constexpr int kFewest = 8;
    const int num_corners = std::max(kFewest, static_cast<int>(std::ceil(4.0 * std::sqrt(radius))));
    std::vector<Point> corners;
    for (int i = 0; i < num_corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_corners;
        corners.push_back(
            {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
    add_polygon(corners);
}

void Shape::add_segment(Point from, Point to, double width) {
    const double length = distance(from, to);
    if (length == 0.0) return;
    const double across_x = -(to.y - from.y) / length * width / 2.0;
    const double across_y = (to.x - from.x) / length * width / 2.0;
    // The same way round as a disc, so that they add up where they overlap.
    const std::array<Point, 4> corners = {{{from.x - across_x, from.y - across_y},
                                           {to.x - across_x, to.y - across_y},
                                           {to.x + across_x, to.y + across_y},
                                           {from.x + across_x, from.y + across_y}}};
    add_polygon(corners);
}

void Shape::add_line(std::span<const Point> points, double width) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        add_disc(points[i], width / 2.0);
        if (i + 1 < points.size()) add_segment(points[i], points[i + 1], width);
    }
}

void Shape::add_closed_line(std::span<const Point> points, double width) {
    add_line(points, width);
    if (points.size() > 2) add_segment(points.back(), points.front(), width);
}

Canvas::Canvas(std::int32_t width, std::int32_t height, Rgb paper)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), paper) {}

void Canvas::fill(const Shape& shape, Rgb color, double opacity) {
    std::vector<Shape::Edge> waiting = shape.edges();
    // Last row first, so that the next edge to begin is at the back.
    std::sort(waiting.begin(), waiting.end(),
              [](const Shape::Edge& a, const Shape::Edge& b) { return a.y0 > b.y0; });
    std::vector<Shape::Edge> active;
    CoverageRow row(width_);
    const auto solid = static_cast<float>(opacity);
    const float first =
        waiting.empty() ? 0.0F : std::clamp(waiting.back().y0, 0.0F, static_cast<float>(height_));
    auto y = static_cast<std::int32_t>(first);
    for (; y < height_ && !(waiting.empty() && active.empty()); ++y) {
        const auto top = static_cast<float>(y);
        const float bottom = top + 1.0F;
        while (!waiting.empty() && waiting.back().y0 < bottom) {
            active.push_back(waiting.back());
            waiting.pop_back();
        }
        for (const Shape::Edge& edge : active) {
            const float from = std::max(edge.y0, top);
            const float to = std::min(edge.y1, bottom);
            if (to <= from) continue;
            const float slope = (edge.x1 - edge.x0) / (edge.y1 - edge.y0);
            row.add(edge.x0 + slope * (from - edge.y0), edge.x0 + slope * (to - edge.y0),
                    edge.winding * (to - from));
        }
        std::erase_if(active, [bottom](const Shape::Edge& edge) { return edge.y1 <= bottom; });
        Rgb* const pixels = pixels_.data() + offset(0, y);
        row.flush([&](std::int32_t begin, std::int32_t end, float coverage) {
            constexpr float kWhole = 0.998F;
            const float share = coverage * solid;
            if (share > kWhole) {
                std::fill(pixels + begin, pixels + end, color);
            } else {
                std::transform(pixels + begin, pixels + end, pixels + begin,
                               [&](Rgb under) { return blended(under, color, share); });
            }
        });
    }
}

std::string Canvas::encode_png() const {
    constexpr int kChannels = 3;
    const ImageHeader header{width_, height_, kChannels, 255};
    return io::encode_png(header, [this](std::int32_t y, std::span<std::uint16_t> samples) {
        for (std::int32_t x = 0; x < width_; ++x) {
            const Rgb color = at(x, y);
            const std::size_t first = static_cast<std::size_t>(x) * kChannels;
            samples[first] = color.red;
            samples[first + 1] = color.green;
            samples[first + 2] = color.blue;
        }
    });
}

}  // namespace quadcut::io
