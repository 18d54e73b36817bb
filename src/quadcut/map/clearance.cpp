// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadcut {
namespace {

constexpr std::size_t kRowsPerChunk = 32;
constexpr std::size_t kColumnsPerChunk = 256;

/// Vertical distance, in cells, to the nearest blocked cell of the same column. Rows are swept
/// whole, so that memory is read in order.
void sweep_columns(const Raster<std::uint8_t>& open, Raster<float>& out, std::size_t first_column,
                   std::size_t last_column) {
    const auto width = static_cast<std::size_t>(open.width);
    const auto height = static_cast<std::size_t>(open.height);
    std::vector<float> distance(last_column - first_column, 0.0F);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = first_column; x < last_column; ++x) {
            float& d = distance[x - first_column];
            d = open.values[y * width + x] != 0 ? d + 1.0F : 0.0F;
            out.values[y * width + x] = d;
        }
    }
    std::fill(distance.begin(), distance.end(), 0.0F);
    for (std::size_t y = height; y-- > 0;) {
        for (std::size_t x = first_column; x < last_column; ++x) {
            float& d = distance[x - first_column];
            float& value = out.values[y * width + x];
            d = value > 0.0F ? d + 1.0F : 0.0F;
            value = std::min(value, d);
        }
    }
}

/// The lower envelope of the parabolas (x - i)^2 + g_i^2 along one row, and its value at each x.
/// Runs of open cells are looked at one by one: no parabola reaches beyond a blocked cell, whose
/// g = 0. Such a cell is at each end; outside of the row all are blocked.
class RowEnvelope {
public:
    explicit RowEnvelope(std::size_t width) : pieces_(width + 2), squared_(width) {}

    void transform(float* row, std::size_t width, float resolution_m) {
        for (std::size_t x = 0; x < width;) {
            if (row[x] == 0.0F) {
                ++x;
                continue;
            }
            const std::size_t begin = x;
            while (x < width && row[x] != 0.0F) ++x;
            transform_run(row, begin, x);
            const auto length = static_cast<std::ptrdiff_t>(x - begin);
            const double farthest = *std::max_element(squared_.begin(), squared_.begin() + length);
            for (std::size_t i = begin; i < x; ++i) {
                const double squared = squared_[i - begin];
                // Whole numbers: below 2^24 the root of the float is the rounded root of the
                // double.
                const float centre_distance = farthest < kExactFloat
                                                  ? std::sqrt(static_cast<float>(squared))
                                                  : static_cast<float>(std::sqrt(squared));
                row[i] = (centre_distance - 0.5F) * resolution_m;
            }
        }
    }

private:
    static constexpr double kExactFloat = 16777216.0;

    /// A parabola that is the lowest from x = numerator / denominator on.
    struct Piece {
        double vertex = 0.0;
        double squared_height = 0.0;
        double numerator = 0.0;
        double denominator = 1.0;
    };

    void transform_run(const float* row, std::size_t begin, std::size_t end) {
        count_ = 0;
        push(static_cast<double>(begin) - 1.0, 0.0);
        for (std::size_t x = begin; x < end; ++x) {
            const auto height = static_cast<double>(row[x]);
            push(static_cast<double>(x), height * height);
        }
        push(static_cast<double>(end), 0.0);
        std::size_t k = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const auto x = static_cast<double>(i);
            while (k + 1 < count_ && pieces_[k + 1].numerator < x * pieces_[k + 1].denominator) ++k;
            const double dx = x - pieces_[k].vertex;
            squared_[i - begin] = dx * dx + pieces_[k].squared_height;
        }
    }

    void push(double vertex, double squared_height) {
        Piece next{vertex, squared_height};
        const double own = squared_height + vertex * vertex;
        while (count_ > 0) {
            const Piece& top = pieces_[count_ - 1];
            // Where the new parabola begins to be the lower one.
            next.numerator = own - top.squared_height - top.vertex * top.vertex;
            next.denominator = 2.0 * (vertex - top.vertex);
            if (count_ == 1 ||
                next.numerator * top.denominator > top.numerator * next.denominator) {
                break;
            }
            --count_;
        }
        pieces_[count_++] = next;
    }

    std::vector<Piece> pieces_;
    std::vector<double> squared_;
    std::size_t count_ = 0;
};

}  // namespace

Raster<float> clearance_m(const Raster<std::uint8_t>& open, double resolution_m,
                          const Executor& executor) {
    Raster<float> out(open.origin, open.width, open.height);
    const auto width = static_cast<std::size_t>(open.width);
    const auto height = static_cast<std::size_t>(open.height);
    parallel_for(executor, width, kColumnsPerChunk, [&](std::size_t first, std::size_t last) {
        sweep_columns(open, out, first, last);
    });
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        RowEnvelope envelope(width);
        for (std::size_t y = first; y < last; ++y) {
            envelope.transform(&out.values[y * width], width, static_cast<float>(resolution_m));
        }
    });
    return out;
}

}  // namespace quadcut
