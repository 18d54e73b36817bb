// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/basins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace quadcut {
namespace {

constexpr double kSmoothingM = 0.05;
constexpr std::size_t kRowsPerChunk = 64;

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

/// Offsets of the positive cells by descending height; equal heights (to 1/64 of a cell) in order
/// of offset. Counting sort.
std::vector<std::uint32_t> cells_downhill(const Raster<float>& clearance,
                                          const Raster<float>& height, double resolution_m) {
    const auto scale = static_cast<float>(64.0 / resolution_m);
    const float highest = *std::max_element(height.values.begin(), height.values.end());
    std::vector<std::size_t> begin(static_cast<std::size_t>(highest * scale) + 2, 0);
    const auto bucket = [&](std::size_t i) {
        return begin.size() - 2 - static_cast<std::size_t>(height.values[i] * scale);
    };
    for (std::size_t i = 0; i < height.values.size(); ++i) {
        if (clearance.values[i] > 0.0F) ++begin[bucket(i) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> order(begin.back());
    for (std::size_t i = 0; i < height.values.size(); ++i) {
        if (clearance.values[i] > 0.0F) order[begin[bucket(i)]++] = static_cast<std::uint32_t>(i);
    }
    return order;
}

}  // namespace

Basins build_basins(const Raster<float>& clearance_m, double resolution_m,
                    const Executor& executor) {
    Basins basins;
    basins.labels =
        Raster<std::uint32_t>(clearance_m.origin, clearance_m.width, clearance_m.height);
    if (clearance_m.values.empty()) return basins;
    const Raster<float> height = smooth(clearance_m, kSmoothingM / resolution_m, executor);
    struct Step {
        std::int32_t dx, dy;
        float inverse_length;
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
    for (const std::uint32_t i : cells_downhill(clearance_m, height, resolution_m)) {
        const auto x = static_cast<std::int32_t>(i % static_cast<std::uint32_t>(height.width));
        const auto y = static_cast<std::int32_t>(i / static_cast<std::uint32_t>(height.width));
        std::uint32_t uphill = 0;
        float steepest = -1e30F;
        for (const Step& step : kSteps) {
            const std::int32_t nx = x + step.dx;
            const std::int32_t ny = y + step.dy;
            if (nx < 0 || ny < 0 || nx >= height.width || ny >= height.height) continue;
            const auto n = static_cast<std::size_t>(ny) * static_cast<std::size_t>(height.width) +
                           static_cast<std::size_t>(nx);
            if (basins.labels.values[n] == 0) continue;
            const float slope = (height.values[n] - height.values[i]) * step.inverse_length;
            if (slope > steepest) {
                steepest = slope;
                uphill = basins.labels.values[n];
            }
        }
        basins.labels.values[i] = uphill != 0 ? uphill : ++basins.count;
    }
    return basins;
}

}  // namespace quadcut
