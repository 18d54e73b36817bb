// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadcut {
namespace {

constexpr std::size_t kRowsPerChunk = 32;

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
/// One parabola outside each end of the row (g = 0) stands for the blocked outside.
class RowEnvelope {
public:
    explicit RowEnvelope(std::size_t width)
        : vertex_(width + 2), height_(width + 2), from_(width + 3) {}

    void transform(float* row, std::size_t width, float resolution_m) {
        count_ = 0;
        push(-1, 0.0);
        for (std::size_t x = 0; x < width; ++x) {
            push(static_cast<std::int64_t>(x), static_cast<double>(row[x]) * row[x]);
        }
        push(static_cast<std::int64_t>(width), 0.0);
        std::size_t k = 0;
        for (std::size_t x = 0; x < width; ++x) {
            while (k + 1 < count_ && from_[k + 1] < static_cast<double>(x)) ++k;
            if (row[x] == 0.0F) continue;
            const double dx = static_cast<double>(x) - static_cast<double>(vertex_[k]);
            const auto centre_distance = static_cast<float>(std::sqrt(dx * dx + height_[k]));
            row[x] = (centre_distance - 0.5F) * resolution_m;
        }
    }

private:
    void push(std::int64_t vertex, double squared_height) {
        while (count_ > 0) {
            const auto top = static_cast<double>(vertex_[count_ - 1]);
            const auto v = static_cast<double>(vertex);
            // Where the new parabola begins to be the lower one.
            const double start =
                (squared_height + v * v - height_[count_ - 1] - top * top) / (2.0 * (v - top));
            if (count_ == 1 || start > from_[count_ - 1]) {
                from_[count_] = start;
                break;
            }
            --count_;
        }
        vertex_[count_] = vertex;
        height_[count_] = squared_height;
        ++count_;
    }

    std::vector<std::int64_t> vertex_;
    std::vector<double> height_;
    std::vector<double> from_;
    std::size_t count_ = 0;
};

}  // namespace

Raster<float> clearance_m(const Raster<std::uint8_t>& open, double resolution_m,
                          const Executor& executor) {
    Raster<float> out(open.origin, open.width, open.height);
    const auto width = static_cast<std::size_t>(open.width);
    const auto height = static_cast<std::size_t>(open.height);
    parallel_for(executor, width, 1024, [&](std::size_t first, std::size_t last) {
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
