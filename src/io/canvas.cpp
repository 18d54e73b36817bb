// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/canvas.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace quadcut::io {
namespace {

constexpr std::size_t kChannels = 3;
constexpr std::size_t kBitsPerWord = 64;

/// The coverage of a band of rows of pixels, as differences along each row: an edge adds to the
/// pixels it crosses, and every pixel to its right inherits the sum. Few pixels of a row differ
/// from the one before, so these are marked, and the rest is painted in spans.
class CoverageBand {
public:
    CoverageBand(std::int32_t width, std::int32_t first, std::int32_t last)
        : width_(width),
          first_(first),
          last_(last),
          words_per_row_(static_cast<std::size_t>(width) / kBitsPerWord + 1),
          rows_(static_cast<std::size_t>(last - first)),
          difference_(rows_.size() * static_cast<std::size_t>(width), 0.0F),
          changed_(rows_.size() * words_per_row_, 0) {}

    void add(const Shape::Edge& edge) {
        const bool down = edge.y0 < edge.y1;
        const float x0 = down ? edge.x0 : edge.x1;
        const float y0 = down ? edge.y0 : edge.y1;
        const float y1 = down ? edge.y1 : edge.y0;
        const float slope = down ? (edge.x1 - edge.x0) / (edge.y1 - edge.y0)
                                 : (edge.x0 - edge.x1) / (edge.y0 - edge.y1);
        const float winding = down ? 1.0F : -1.0F;
        const auto band_top = static_cast<float>(first_);
        const auto band_bottom = static_cast<float>(last_);
        auto y = static_cast<std::int32_t>(std::clamp(y0, band_top, band_bottom));
        for (; y < last_; ++y) {
            const auto top = static_cast<float>(y);
            const float from = std::max(y0, top);
            const float to = std::min(y1, top + 1.0F);
            if (to <= from) break;
            add(static_cast<std::size_t>(y - first_), x0 + slope * (from - y0),
                x0 + slope * (to - y0), winding * (to - from));
        }
    }

    /// Calls `paint(y, begin, end, coverage)` for each span of row y, pixels begin .. end - 1, that
    /// is covered, and clears the band.
    template <typename Paint>
    void flush(const Paint& paint) {
        for (std::int32_t y = first_; y < last_; ++y) {
            Row& row = rows_[static_cast<std::size_t>(y - first_)];
            if (row.low > row.high) continue;
            flush_row(y, row, paint);
            row = {};
        }
    }

private:
    /// Which words of the marks of a row are not 0, at most.
    struct Row {
        std::size_t low = std::numeric_limits<std::size_t>::max();
        std::size_t high = 0;
    };

    /// The part of an edge within a row: x at its upper and lower end, and its height (0..1) with
    /// the sign of its winding.
    void add(std::size_t row, float x_top, float x_bottom, float height) {
        const auto limit = static_cast<float>(width_);
        const float left = std::clamp(std::min(x_top, x_bottom), 0.0F, limit);
        const float right = std::clamp(std::max(x_top, x_bottom), 0.0F, limit);
        const auto first = static_cast<std::int32_t>(left);
        const auto last = static_cast<std::int32_t>(right);
        if (first == last) {
            // The pixel's share to the right of the edge is a trapezoid; those beyond are covered.
            const float inside = static_cast<float>(first) + 1.0F - 0.5F * (left + right);
            add_at(row, first, height * inside);
            add_at(row, first + 1, height * (1.0F - inside));
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
            add_at(row, x, inside - previous);
            previous = inside;
            covered += crossed;
        }
        add_at(row, last + 1, height - previous);
    }

    void add_at(std::size_t row, std::int32_t column, float value) {
        if (column >= width_) return;
        const auto x = static_cast<std::size_t>(column);
        const std::size_t word = x / kBitsPerWord;
        difference_[row * static_cast<std::size_t>(width_) + x] += value;
        changed_[row * words_per_row_ + word] |= std::uint64_t{1} << (x % kBitsPerWord);
        rows_[row].low = std::min(rows_[row].low, word);
        rows_[row].high = std::max(rows_[row].high, word);
    }

    template <typename Paint>
    void flush_row(std::int32_t y, const Row& row, const Paint& paint) {
        constexpr float kLeast = 1.0F / 512.0F;
        const auto place = static_cast<std::size_t>(y - first_);
        float* const difference = difference_.data() + place * static_cast<std::size_t>(width_);
        std::uint64_t* const changed = changed_.data() + place * words_per_row_;
        float coverage = 0.0F;
        float sum = 0.0F;
        std::size_t span_begin = 0;
        for (std::size_t word = row.low; word <= row.high; ++word) {
            for (; changed[word] != 0; changed[word] &= changed[word] - 1) {
                const std::size_t x =
                    word * kBitsPerWord + static_cast<std::size_t>(std::countr_zero(changed[word]));
                if (coverage > kLeast) paint(y, span_begin, x, coverage);
                sum += difference[x];
                difference[x] = 0.0F;
                coverage = std::min(std::abs(sum), 1.0F);
                span_begin = x;
            }
        }
        if (coverage > kLeast) paint(y, span_begin, static_cast<std::size_t>(width_), coverage);
    }

    std::int32_t width_;
    std::int32_t first_;
    std::int32_t last_;
    std::size_t words_per_row_;
    std::vector<Row> rows_;
    std::vector<float> difference_;
    /// A bit for each pixel: whether its difference was changed.
    std::vector<std::uint64_t> changed_;
};

void fill_span(std::uint8_t* to, std::size_t num_pixels, Rgb color) {
    constexpr std::size_t kSeed = 16;
    const std::size_t num_seeds = std::min(num_pixels, kSeed);
    for (std::size_t i = 0; i < num_seeds; ++i) {
        to[kChannels * i] = color.red;
        to[kChannels * i + 1] = color.green;
        to[kChannels * i + 2] = color.blue;
    }
    // What is there is doubled.
    const std::size_t num_bytes = kChannels * num_pixels;
    for (std::size_t done = kChannels * num_seeds; done < num_bytes;) {
        const std::size_t more = std::min(done, num_bytes - done);
        std::memcpy(to + done, to, more);
        done += more;
    }
}

void blend_span(std::uint8_t* to, std::size_t num_pixels, Rgb color, float share) {
    const std::array<float, kChannels> over = {static_cast<float>(color.red),
                                               static_cast<float>(color.green),
                                               static_cast<float>(color.blue)};
    for (std::size_t i = 0; i < num_pixels; ++i) {
        for (const float above : over) {
            const auto below = static_cast<float>(*to);
            *to++ = static_cast<std::uint8_t>(below + share * (above - below) + 0.5F);
        }
    }
}

/// Of each band of `num_rows` rows, the edges that meet it, ascending; the last entry of `begin` is
/// the number of all.
struct EdgesOfBands {
    std::vector<std::size_t> begin;
    std::vector<std::uint32_t> edges;
};

EdgesOfBands sort_into_bands(const std::vector<Shape::Edge>& edges, std::size_t height,
                             std::size_t num_rows) {
    const std::size_t num_bands = (height + num_rows - 1) / num_rows;
    const auto limit = static_cast<float>(height - 1);
    const auto band_of = [&](float y) {
        return static_cast<std::size_t>(std::clamp(y, 0.0F, limit)) / num_rows;
    };
    const auto for_each_band = [&](const auto& visit) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const auto [low, high] = std::minmax(edges[i].y0, edges[i].y1);
            const std::size_t last = band_of(high);
            for (std::size_t band = band_of(low); band <= last; ++band) visit(band, i);
        }
    };
    EdgesOfBands sorted;
    sorted.begin.assign(num_bands + 2, 0);
    // Two places ahead, so that filling the bands leaves the beginnings.
    for_each_band([&](std::size_t band, std::size_t) { ++sorted.begin[band + 2]; });
    for (std::size_t band = 2; band < sorted.begin.size(); ++band) {
        sorted.begin[band] += sorted.begin[band - 1];
    }
    sorted.edges.resize(sorted.begin.back());
    for_each_band([&](std::size_t band, std::size_t i) {
        sorted.edges[sorted.begin[band + 1]++] = static_cast<std::uint32_t>(i);
    });
    sorted.begin.pop_back();
    return sorted;
}

/// The corners of a disc around (0, 0).
std::vector<Point> disc_corners(double radius) {
    constexpr int kFewest = 8;
    const int num_corners = std::max(kFewest, static_cast<int>(std::ceil(4.0 * std::sqrt(radius))));
    std::vector<Point> corners;
    for (int i = 0; i < num_corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_corners;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return corners;
}

}  // namespace

void Shape::add_edge(Point from, Point to) {
    const auto y0 = static_cast<float>(from.y);
    const auto y1 = static_cast<float>(to.y);
    if (y0 == y1) return;
    edges_.push_back({static_cast<float>(from.x), y0, static_cast<float>(to.x), y1});
}

void Shape::add_polygon(std::span<const Point> points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) add_edge(points[i], points[i + 1]);
    if (!points.empty()) add_edge(points.back(), points.front());
}

void Shape::add_discs(std::span<const Point> centers, double radius) {
    const std::vector<Point> corners = disc_corners(radius);
    for (const Point& center : centers) {
        Point from{center.x + corners.back().x, center.y + corners.back().y};
        for (const Point& corner : corners) {
            const Point to{center.x + corner.x, center.y + corner.y};
            add_edge(from, to);
            from = to;
        }
    }
}

void Shape::add_disc(Point center, double radius) { add_discs({&center, 1}, radius); }

void Shape::add_segment(Point from, Point to, double width) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0.0) return;
    const double across_x = -dy / length * width / 2.0;
    const double across_y = dx / length * width / 2.0;
    // The same way round as a disc, so that they add up where they overlap.
    const std::array<Point, 4> corners = {{{from.x - across_x, from.y - across_y},
                                           {to.x - across_x, to.y - across_y},
                                           {to.x + across_x, to.y + across_y},
                                           {from.x + across_x, from.y + across_y}}};
    add_polygon(corners);
}

void Shape::add_line(std::span<const Point> points, double width) {
    add_discs(points, width / 2.0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        add_segment(points[i], points[i + 1], width);
    }
}

void Shape::add_closed_line(std::span<const Point> points, double width) {
    add_line(points, width);
    if (points.size() > 2) add_segment(points.back(), points.front(), width);
}

Canvas::Canvas(std::int32_t width, std::int32_t height, Rgb paper)
    : width_(width), height_(height), paper_(paper) {}

void Canvas::fill(const Shape& shape, Rgb color, double opacity) {
    const auto right = static_cast<float>(width_);
    const auto bottom = static_cast<float>(height_);
    for (const Shape::Edge& edge : shape.edges()) {
        const bool outside = std::max(edge.y0, edge.y1) <= 0.0F ||
                             std::min(edge.y0, edge.y1) >= bottom ||
                             std::min(edge.x0, edge.x1) >= right;
        if (!outside) edges_.push_back(edge);
    }
    if (edges_.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw std::logic_error("Canvas: too many edges");
    }
    layers_.push_back({edges_.size(), color, static_cast<float>(opacity)});
}

void Canvas::paint(std::span<const std::uint32_t> edges, const ImageBand& band) const {
    const auto width = static_cast<std::size_t>(width_);
    for (std::int32_t y = band.first; y < band.last; ++y) fill_span(band.row(y), width, paper_);
    CoverageBand coverage(width_, band.first, band.last);
    auto edge = edges.begin();
    for (const Layer& layer : layers_) {
        if (edge == edges.end()) break;
        if (*edge >= layer.end) continue;
        for (; edge != edges.end() && *edge < layer.end; ++edge) coverage.add(edges_[*edge]);
        coverage.flush([&](std::int32_t y, std::size_t begin, std::size_t end, float covered) {
            constexpr float kWhole = 0.998F;
            const float share = covered * layer.opacity;
            std::uint8_t* const to = band.row(y) + kChannels * begin;
            if (share > kWhole) {
                fill_span(to, end - begin, layer.color);
            } else {
                blend_span(to, end - begin, layer.color, share);
            }
        });
    }
}

Rgb Canvas::at(std::int32_t x, std::int32_t y) const {
    std::vector<std::uint32_t> edges(edges_.size());
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = static_cast<std::uint32_t>(i);
    std::vector<std::uint8_t> row(kChannels * static_cast<std::size_t>(width_));
    paint(edges, {y, y + 1, row.data(), row.size()});
    const std::uint8_t* const pixel = row.data() + kChannels * static_cast<std::size_t>(x);
    return {pixel[0], pixel[1], pixel[2]};
}

std::string Canvas::encode_png(const Executor& executor) const {
    const auto height = static_cast<std::size_t>(height_);
    const ImageHeader header{width_, height_, static_cast<int>(kChannels), 255};
    const std::size_t num_rows = rows_per_band(header);
    const EdgesOfBands sorted = sort_into_bands(edges_, height, num_rows);
    return encode_png_bands(
        header,
        [&](const ImageBand& band) {
            const std::size_t place = static_cast<std::size_t>(band.first) / num_rows;
            paint(std::span(sorted.edges)
                      .subspan(sorted.begin[place], sorted.begin[place + 1] - sorted.begin[place]),
                  band);
        },
        executor);
}

}  // namespace quadcut::io
