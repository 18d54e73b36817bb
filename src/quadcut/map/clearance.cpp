// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
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

/// The lower envelope of the parabolas (x - i)^2 + g_i^2 along one row, and its value at each x
/// (Meijster, Roerdink, Hesselink, "A general algorithm for computing distance transforms in linear
/// time", 2000). Runs of open cells are looked at one by one: no parabola reaches beyond a blocked
/// cell, whose g = 0. Such a cell is at each end; outside of the row all are blocked. `Whole` holds
/// the square of the row's length and of the largest g, four times.
template <typename Whole>
class RowEnvelope {
public:
    explicit RowEnvelope(std::size_t width)
        : squares_(width + 2), vertex_(width + 2), start_(width + 2) {}

    void transform(float* row, std::size_t width, float resolution_m) {
        for (std::size_t x = 0; x < width;) {
            if (row[x] == 0.0F) {
                ++x;
                continue;
            }
            const std::size_t begin = x;
            while (x < width && row[x] != 0.0F) ++x;
            transform_run(row + begin, static_cast<Whole>(x - begin), resolution_m);
        }
    }

private:
    /// Cells 1 .. length between two blocked ones.
    void transform_run(float* row, Whole length, float resolution_m) {
        Whole* const squares = squares_.data();
        squares[0] = 0;
        squares[length + 1] = 0;
        for (Whole x = 1; x <= length; ++x) {
            const auto height = static_cast<Whole>(row[x - 1]);
            squares[x] = height * height;
        }
        // Pieces of the envelope: whose parabola, and from which cell on.
        Whole* const vertex = vertex_.data();
        Whole* const start = start_.data();
        Whole top = 0;
        vertex[0] = 0;
        start[0] = 0;
        for (Whole x = 1; x <= length + 1; ++x) {
            const auto height_at = [&](Whole cell, Whole of) {
                return (cell - of) * (cell - of) + squares[of];
            };
            while (height_at(start[top], vertex[top]) > height_at(start[top], x)) --top;
            const Whole before = vertex[top];
            const Whole across = x - before;
            const Whole numerator = across * (x + before) + squares[x] - squares[before];
            const Whole from = 1 + (across == 1 ? numerator / 2 : numerator / (2 * across));
            if (from > length) continue;
            ++top;
            vertex[top] = x;
            start[top] = from;
        }
        for (Whole x = length; x >= 1; --x) {
            while (x < start[top]) --top;
            const Whole across = x - vertex[top];
            row[x - 1] = root(across * across + squares[vertex[top]]);
        }
        for (Whole x = 0; x < length; ++x) row[x] = (row[x] - 0.5F) * resolution_m;
    }

    /// Below 2^24 the root of the float is the rounded root of the double.
    static float root(Whole squared) {
        constexpr Whole kExactFloat = 1 << 24;
        if (squared < kExactFloat) return std::sqrt(static_cast<float>(squared));
        return static_cast<float>(std::sqrt(static_cast<double>(squared)));
    }

    std::vector<Whole> squares_;
    std::vector<Whole> vertex_;
    std::vector<Whole> start_;
};

template <typename Whole>
void transform_rows(Raster<float>& out, double resolution_m, const Executor& executor) {
    const auto width = static_cast<std::size_t>(out.width);
    parallel_for(executor, static_cast<std::size_t>(out.height), kRowsPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     RowEnvelope<Whole> envelope(width);
                     for (std::size_t y = first; y < last; ++y) {
                         envelope.transform(&out.values[y * width], width,
                                            static_cast<float>(resolution_m));
                     }
                 });
}

}  // namespace

Raster<float> clearance_m(const Raster<std::uint8_t>& open, double resolution_m,
                          const Executor& executor, Raster<float> memory) {
    Raster<float> out = std::move(memory);
    out.origin = open.origin;
    out.width = open.width;
    out.height = open.height;
    if (out.values.capacity() < open.values.size()) out.values = {};
    out.values.resize(open.values.size());
    const auto width = static_cast<std::size_t>(open.width);
    parallel_for(executor, width, kColumnsPerChunk, [&](std::size_t first, std::size_t last) {
        sweep_columns(open, out, first, last);
    });
    constexpr std::int32_t kMaxSide = 16000;
    if (open.width < kMaxSide && open.height < kMaxSide) {
        transform_rows<std::int32_t>(out, resolution_m, executor);
    } else {
        transform_rows<std::int64_t>(out, resolution_m, executor);
    }
    return out;
}

}  // namespace quadcut
