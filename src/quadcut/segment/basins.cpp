// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/basins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

constexpr double kSmoothingM = 0.05;
constexpr std::size_t kRowsPerChunk = 64;
constexpr std::size_t kCellsPerChunk = std::size_t{1} << 16U;

std::vector<float> gaussian_kernel(double sigma_cells) {
    const int radius = static_cast<int>(std::ceil(3.0 * sigma_cells));
    std::vector<float> kernel;
    for (int i = -radius; i <= radius; ++i) {
        kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma_cells * sigma_cells))));
    }
    const float sum = std::accumulate(kernel.begin(), kernel.end(), 0.0F);
    for (float& k : kernel) k /= sum;
    return kernel;
}

/// Separable smoothing; the outside counts as 0, as it has no clearance.
Raster<float> smooth(const Raster<float>& in, double sigma_cells, const Executor& executor) {
    const std::vector<float> kernel = gaussian_kernel(sigma_cells);
    const auto radius = static_cast<std::int32_t>(kernel.size() / 2);
    if (radius == 0) return in;
    const auto width = static_cast<std::size_t>(in.width);
    const auto height = static_cast<std::size_t>(in.height);
    Raster<float> across(in.origin, in.width, in.height);
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
            const float* row = &in.values[y * width];
            float* out = &across.values[y * width];
            for (std::int32_t k = -radius; k <= radius; ++k) {
                const float weight = kernel[static_cast<std::size_t>(k + radius)];
                const std::int32_t end = std::min(in.width, in.width - k);
                for (std::int32_t x = std::max(0, -k); x < end; ++x) out[x] += weight * row[x + k];
            }
        }
    });
    Raster<float> result(in.origin, in.width, in.height);
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
            float* out = &result.values[y * width];
            for (std::int32_t k = -radius; k <= radius; ++k) {
                const std::int64_t from = static_cast<std::int64_t>(y) + k;
                if (from < 0 || from >= in.height) continue;
                const float weight = kernel[static_cast<std::size_t>(k + radius)];
                const float* row = &across.values[static_cast<std::size_t>(from) * width];
                for (std::size_t x = 0; x < width; ++x) out[x] += weight * row[x];
            }
        }
    });
    return result;
}

/// Heights in steps of 1/64 of a cell; -1 where there is no clearance.
Raster<std::int32_t> levels_of(const Raster<float>& clearance, const Raster<float>& height,
                               double resolution_m, const Executor& executor) {
    const auto scale = static_cast<float>(64.0 / resolution_m);
    Raster<std::int32_t> level(height.origin, height.width, height.height);
    parallel_for(executor, level.values.size(), kCellsPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i) {
                         const auto steps = static_cast<std::int32_t>(height.values[i] * scale);
                         level.values[i] = clearance.values[i] > 0.0F ? steps : -1;
                     }
                 });
    return level;
}

/// A step to a neighbour. Of cells of one level the one with the smaller offset is the higher.
struct Step {
    std::int32_t dx, dy;
    float inverse_length;
    [[nodiscard]] bool leads_back() const { return dy < 0 || (dy == 0 && dx < 0); }
};
constexpr float kDiagonal = 0.70710678F;
constexpr std::array<Step, 8> kSteps{{{1, 0, 1.0F},
                                      {-1, 0, 1.0F},
                                      {0, 1, 1.0F},
                                      {0, -1, 1.0F},
                                      {1, 1, kDiagonal},
                                      {-1, 1, kDiagonal},
                                      {1, -1, kDiagonal},
                                      {-1, -1, kDiagonal}}};

/// For the cells of one row, the offset of the neighbour to which it goes up most steeply, or of
/// the cell itself where all are lower.
class RowAscent {
public:
    RowAscent(const Raster<float>& height, const Raster<std::int32_t>& level)
        : height_(height),
          level_(level),
          width_(static_cast<std::size_t>(height.width)),
          steepest_(width_),
          ahead_(width_) {}

    void find(std::size_t y, std::uint32_t* uphill) {
        std::fill(steepest_.begin(), steepest_.end(), -1e30F);
        std::fill(ahead_.begin(), ahead_.end(), 0);
        for (const Step& step : kSteps) {
            if ((step.dy < 0 && y == 0) ||
                (step.dy > 0 && y + 1 == static_cast<std::size_t>(height_.height))) {
                continue;
            }
            look(y, step);
        }
        const std::size_t row = y * width_;
        for (std::size_t x = 0; x < width_; ++x) {
            uphill[x] = static_cast<std::uint32_t>(static_cast<std::int64_t>(row + x) + ahead_[x]);
        }
    }

private:
    void look(std::size_t y, const Step& step) {
        const std::int32_t ahead = step.dy * height_.width + step.dx;
        const std::size_t begin = step.dx < 0 ? 1 : 0;
        const std::size_t end = step.dx > 0 ? width_ - 1 : width_;
        const auto row = static_cast<std::int64_t>(y * width_);
        const float* const own = height_.values.data() + row;
        const float* const next = own + ahead;
        const std::int32_t* const own_level = level_.values.data() + row;
        const std::int32_t* const next_level = own_level + ahead;
        const std::int32_t more = step.leads_back() ? 0 : 1;
        for (std::size_t x = begin; x < end; ++x) {
            const float slope = (next[x] - own[x]) * step.inverse_length;
            const bool is_higher = next_level[x] >= own_level[x] + more;
            const bool is_steeper = is_higher & (slope > steepest_[x]);
            steepest_[x] = is_steeper ? slope : steepest_[x];
            ahead_[x] = is_steeper ? ahead : ahead_[x];
        }
    }

    const Raster<float>& height_;
    const Raster<std::int32_t>& level_;
    std::size_t width_;
    std::vector<float> steepest_;
    std::vector<std::int32_t> ahead_;
};

/// The peaks, where nothing goes up, numbered from the highest down; their labels.
std::uint32_t number_peaks(const std::vector<std::uint32_t>& uphill,
                           const Raster<std::int32_t>& level, Raster<std::uint32_t>& labels) {
    std::vector<std::uint32_t> peaks;
    for (std::uint32_t i = 0; i < uphill.size(); ++i) {
        if (uphill[i] == i && level.values[i] >= 0) peaks.push_back(i);
    }
    std::stable_sort(peaks.begin(), peaks.end(), [&](std::uint32_t a, std::uint32_t b) {
        return level.values[a] > level.values[b];
    });
    std::uint32_t count = 0;
    for (const std::uint32_t peak : peaks) labels.values[peak] = ++count;
    return count;
}

}  // namespace

Basins build_basins(const Raster<float>& clearance_m, double resolution_m,
                    const Executor& executor) {
    Basins basins;
    basins.labels =
        Raster<std::uint32_t>(clearance_m.origin, clearance_m.width, clearance_m.height);
    if (clearance_m.values.empty()) return basins;
    const auto width = static_cast<std::size_t>(clearance_m.width);
    const auto height = static_cast<std::size_t>(clearance_m.height);
    std::vector<std::uint32_t> uphill(clearance_m.values.size());
    const Raster<float> smoothed = smooth(clearance_m, kSmoothingM / resolution_m, executor);
    const Raster<std::int32_t> level = levels_of(clearance_m, smoothed, resolution_m, executor);
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        RowAscent ascent(smoothed, level);
        for (std::size_t y = first; y < last; ++y) ascent.find(y, &uphill[y * width]);
    });
    basins.count = number_peaks(uphill, level, basins.labels);
    std::vector<std::uint32_t>& labels = basins.labels.values;
    // First up to the last cell of the own rows, so that no way is gone all along again and again.
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        const auto begin = static_cast<std::uint32_t>(first * width);
        const auto end = static_cast<std::uint32_t>(last * width);
        for (std::uint32_t i = begin; i < end; ++i) {
            std::uint32_t top = i;
            while (uphill[top] != top && uphill[top] >= begin && uphill[top] < end) top = uphill[top];
            for (std::uint32_t at = i; at != top;) at = std::exchange(uphill[at], top);
        }
    });
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first * width; i < last * width; ++i) {
            if (level.values[i] < 0) continue;
            std::uint32_t top = uphill[i];
            while (uphill[top] != top) top = uphill[top];
            if (top != i) labels[i] = labels[top];
        }
    });
    return basins;
}

}  // namespace quadcut
