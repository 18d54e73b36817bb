// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/canvas.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>

namespace quadcut::draw {
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

    [[nodiscard]] double top() const { return first_; }
    [[nodiscard]] double bottom() const { return last_; }

    /// A side of the area; it may lie anywhere.
    void add(Point start, Point end) {
        const auto start_y = static_cast<float>(start.y);
        const auto end_y = static_cast<float>(end.y);
        if (start_y == end_y) return;
        const bool down = start_y < end_y;
        const Point& upper = down ? start : end;
        const Point& lower = down ? end : start;
        const auto x0 = static_cast<float>(upper.x);
        const auto y0 = static_cast<float>(upper.y);
        const auto y1 = static_cast<float>(lower.y);
        const float slope = (static_cast<float>(lower.x) - x0) / (y1 - y0);
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

void fill_span(std::uint8_t* to, std::size_t num_pixels, io::Rgb color) {
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

void blend_span(std::uint8_t* to, std::size_t num_pixels, io::Rgb color, float share) {
    const std::array<float, kChannels> over = {static_cast<float>(color.red),
                                               static_cast<float>(color.green),
                                               static_cast<float>(color.blue)};
    constexpr float kToNearest = 0.5F;  // The levels are not negative.
    for (std::size_t i = 0; i < num_pixels; ++i) {
        for (const float above : over) {
            const auto below = static_cast<float>(*to);
            *to++ = static_cast<std::uint8_t>(below + share * (above - below) + kToNearest);
        }
    }
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

/// Whether something between these two heights is in the band.
bool meets(const CoverageBand& band, double y0, double y1) {
    return std::max(y0, y1) >= band.top() && std::min(y0, y1) <= band.bottom();
}

void add_polygon(CoverageBand& band, std::span<const Point> points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (meets(band, points[i].y, points[i + 1].y)) band.add(points[i], points[i + 1]);
    }
    if (!points.empty()) band.add(points.back(), points.front());
}

void add_segment(CoverageBand& band, Point from, Point to, double width) {
    if (!meets(band, std::min(from.y, to.y) - width, std::max(from.y, to.y) + width)) return;
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
    add_polygon(band, corners);
}

void add_thick_line(CoverageBand& band, std::span<const Point> points, double width,
                    bool is_closed) {
    const std::vector<Point> corners = disc_corners(width / 2.0);
    for (const Point& center : points) {
        if (!meets(band, center.y - width, center.y + width)) continue;
        Point from{center.x + corners.back().x, center.y + corners.back().y};
        for (const Point& corner : corners) {
            const Point to{center.x + corner.x, center.y + corner.y};
            band.add(from, to);
            from = to;
        }
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        add_segment(band, points[i], points[i + 1], width);
    }
    if (is_closed && points.size() > 2) add_segment(band, points.back(), points.front(), width);
}

void add_shape(CoverageBand& band, const Shape& shape) {
    std::size_t begin = 0;
    for (const Shape::Line& line : shape.lines()) {
        const auto points = std::span(shape.points()).subspan(begin, line.end - begin);
        begin = line.end;
        if (!meets(band, line.top, line.bottom)) continue;
        if (line.ink == Shape::Ink::inside) {
            add_polygon(band, points);
        } else {
            add_thick_line(band, points, line.width, line.ink == Shape::Ink::closed_line);
        }
    }
}

/// Whether the shape would be painted on nothing but its own colour, as the white around letters
/// mostly is: then it need not be.
bool is_on_its_color(const io::ImageBand& band, std::int32_t width, const Shape& shape,
                     io::Rgb color) {
    const auto column = [width](double x) {
        return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(width)));
    };
    const auto row = [&band](double y) {
        return static_cast<std::int32_t>(
            std::clamp(y, static_cast<double>(band.first), static_cast<double>(band.last)));
    };
    const std::size_t left = column(shape.low().x - 1.0);
    const std::size_t right = column(shape.high().x + 2.0);
    const std::int32_t bottom = row(shape.high().y + 2.0);
    for (std::int32_t y = row(shape.low().y - 1.0); y < bottom; ++y) {
        const std::uint8_t* const pixels = band.row(y);
        for (std::size_t i = kChannels * left; i < kChannels * right; i += kChannels) {
            if (io::Rgb{pixels[i], pixels[i + 1], pixels[i + 2]} != color) return false;
        }
    }
    return true;
}

}  // namespace

void Shape::add(std::span<const Point> points, Ink ink, double width) {
    if (points.empty()) return;
    Line line{points_.size() + points.size(), width, points[0].y, points[0].y, ink};
    for (const Point& point : points) {
        line.top = std::min(line.top, point.y - width);
        line.bottom = std::max(line.bottom, point.y + width);
        low_.x = std::min(low_.x, point.x - width);
        high_.x = std::max(high_.x, point.x + width);
    }
    low_.y = std::min(low_.y, line.top);
    high_.y = std::max(high_.y, line.bottom);
    points_.insert(points_.end(), points.begin(), points.end());
    lines_.push_back(line);
}

void Shape::add_polygon(std::span<const Point> points) { add(points, Ink::inside, 0.0); }

void Shape::add_disc(Point center, double radius) { add_line({&center, 1}, 2.0 * radius); }

void Shape::add_line(std::span<const Point> points, double width) { add(points, Ink::line, width); }

void Shape::add_closed_line(std::span<const Point> points, double width) {
    add(points, Ink::closed_line, width);
}

Canvas::Canvas(std::int32_t width, std::int32_t height, io::Rgb paper)
    : width_(width), height_(height), paper_(paper) {}

void Canvas::fill(Shape shape, io::Rgb color, double opacity) {
    layers_.push_back({std::move(shape), color, static_cast<float>(opacity)});
}

void Canvas::paint(const io::ImageBand& band) const {
    const auto width = static_cast<std::size_t>(width_);
    for (std::int32_t y = band.first; y < band.last; ++y) fill_span(band.row(y), width, paper_);
    CoverageBand coverage(width_, band.first, band.last);
    for (const Layer& layer : layers_) {
        if (!meets(coverage, layer.shape.low().y, layer.shape.high().y) ||
            is_on_its_color(band, width_, layer.shape, layer.color)) {
            continue;
        }
        add_shape(coverage, layer.shape);
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

io::Rgb Canvas::at(std::int32_t x, std::int32_t y) const {
    std::vector<std::uint8_t> row(kChannels * static_cast<std::size_t>(width_));
    paint({y, y + 1, row.data(), row.size()});
    const std::uint8_t* const pixel = row.data() + kChannels * static_cast<std::size_t>(x);
    return {pixel[0], pixel[1], pixel[2]};
}

std::string Canvas::encode_png(const Executor& executor) const {
    const io::ImageHeader header{width_, height_, static_cast<int>(kChannels), 255};
    return io::encode_png_bands(
        header, [this](const io::ImageBand& band) { paint(band); }, executor);
}

}  // namespace quadcut::draw
