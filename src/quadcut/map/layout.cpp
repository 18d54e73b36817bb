// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/layout.hpp"

#include <vector>

namespace quadcut {
namespace {

constexpr std::size_t kMaxParts = 16;

/// About the mean.
double spread(const AxisMoments& m) { return m.s2 / m.n - m.s1 * m.s1 / (m.n * m.n); }
double skew(const AxisMoments& m) {
    const double mean = m.s1 / m.n;
    return m.s3 / m.n - 3.0 * mean * m.s2 / m.n + 2.0 * mean * mean * mean;
}

/// Of a coordinate that counts[i] cells have at low + i, about the middle between first and last.
struct AxisCounts {
    std::vector<std::uint32_t> counts;
    std::int32_t low = 0;

    [[nodiscard]] std::int32_t first() const {
        const auto found = std::find_if(counts.begin(), counts.end(), is_positive);
        return low + static_cast<std::int32_t>(found - counts.begin());
    }
    [[nodiscard]] std::int32_t last() const {
        const auto found = std::find_if(counts.rbegin(), counts.rend(), is_positive);
        return low + static_cast<std::int32_t>(counts.rend() - found) - 1;
    }
    [[nodiscard]] AxisMoments moments() const {
        AxisMoments sums;
        const double middle = 0.5 * (first() + last());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double at = low + static_cast<std::int32_t>(i) - middle;
            const auto count = static_cast<double>(counts[i]);
            sums.n += count;
            sums.s1 += count * at;
            sums.s2 += count * at * at;
            sums.s3 += count * at * at * at;
        }
        return sums;
    }

private:
    static bool is_positive(std::uint32_t count) { return count > 0; }
};

}  // namespace

Layout standard_orientation(const AxisMoments& x, const AxisMoments& y) {
    Layout layout;
    layout.is_transposed = spread(y) > spread(x);
    const bool x_back = skew(x) < 0.0;
    const bool y_back = skew(y) < 0.0;
    layout.is_x_reversed = layout.is_transposed ? y_back : x_back;
    layout.is_y_reversed = layout.is_transposed ? x_back : y_back;
    return layout;
}

Layout standard_layout(const Raster<std::uint8_t>& mask, const Executor& executor) {
    const auto width = static_cast<std::size_t>(mask.width);
    const auto height = static_cast<std::size_t>(mask.height);
    AxisCounts x{std::vector<std::uint32_t>(width, 0), mask.origin.x};
    AxisCounts y{std::vector<std::uint32_t>(height, 0), mask.origin.y};
    const std::size_t num_rows = std::max<std::size_t>(64, height / kMaxParts + 1);
    std::vector<std::vector<std::uint32_t>> columns((height + num_rows - 1) / num_rows);
    parallel_for(executor, height, num_rows, [&](std::size_t first, std::size_t last) {
        std::vector<std::uint32_t>& own = columns[first / num_rows];
        own.resize(width, 0);
        for (std::size_t row = first; row < last; ++row) {
            const std::uint8_t* const cells = &mask.values[row * width];
            std::uint32_t count = 0;
            for (std::size_t i = 0; i < width; ++i) {
                const std::uint32_t is_in = cells[i] != 0 ? 1 : 0;
                own[i] += is_in;
                count += is_in;
            }
            y.counts[row] = count;
        }
    });
    for (const auto& own : columns) {
        for (std::size_t i = 0; i < width; ++i) x.counts[i] += own[i];
    }
    if (x.first() > x.last()) return {};
    Layout layout = standard_orientation(x.moments(), y.moments());
    layout.box = {{x.first() - 1, y.first() - 1}, {x.last() + 1, y.last() + 1}};
    return layout;
}

}  // namespace quadcut
