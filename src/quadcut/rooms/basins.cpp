// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/basins.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"
#include "quadcut/base/wide_vectors.hpp"
#include "quadcut/map/connected_parts.hpp"

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

/// Rows first .. last - 1 of a raster that is made for them only, with a column more at both ends.
struct Rows {
    std::int64_t first;
    std::int64_t last;
    std::size_t stride;
    std::vector<float> values;

    Rows(std::int64_t first_row, std::int64_t last_row, std::size_t width)
        : first(first_row),
          last(last_row),
          stride(width + 2),
          values(static_cast<std::size_t>(last_row - first_row) * stride) {}
    /// From column 0 on.
    [[nodiscard]] float* row(std::int64_t y) {
        return values.data() + static_cast<std::size_t>(y - first) * stride + 1;
    }
    [[nodiscard]] const float* row(std::int64_t y) const {
        return values.data() + static_cast<std::size_t>(y - first) * stride + 1;
    }
};

QUADCUT_WIDE_VECTORS void add_weighted(float* out, const float* row, float weight,
                                       std::int64_t count) {
    for (std::int64_t x = 0; x < count; ++x) out[x] += weight * row[x];
}

/// Separable smoothing of some rows; the outside counts as 0, as it has no clearance.
Rows smooth(const Raster<float>& in, const std::vector<float>& kernel, std::int64_t first,
            std::int64_t last) {
    const auto radius = static_cast<std::int64_t>(kernel.size() / 2);
    const auto width = static_cast<std::int64_t>(in.width);
    Rows across(std::max<std::int64_t>(0, first - radius),
                std::min<std::int64_t>(in.height, last + radius), static_cast<std::size_t>(width));
    for (std::int64_t y = across.first; y < across.last; ++y) {
        const float* const row = in.values.data() + y * width;
        float* const out = across.row(y);
        for (std::int64_t k = -radius; k <= radius; ++k) {
            const float weight = kernel[static_cast<std::size_t>(k + radius)];
            const std::int64_t begin = std::max<std::int64_t>(0, -k);
            const std::int64_t count = std::min(width, width - k) - begin;
            if (count > 0) add_weighted(out + begin, row + begin + k, weight, count);
        }
    }
    Rows result(first, last, static_cast<std::size_t>(width));
    for (std::int64_t y = first; y < last; ++y) {
        float* const out = result.row(y);
        for (std::int64_t k = -radius; k <= radius; ++k) {
            if (y + k < across.first || y + k >= across.last) continue;
            add_weighted(out, across.row(y + k), kernel[static_cast<std::size_t>(k + radius)],
                         width);
        }
    }
    return result;
}

/// While ways are still followed, a cell holds the offset to which it leads; then its label.
constexpr std::uint32_t kIsLabel = std::uint32_t{1} << 31U;

/// To a neighbour, which is higher from so many levels more on: of cells of one level the one that
/// comes first is the higher.
struct Step {
    std::int32_t dx, dy;
    float inverse_length;
    std::int32_t more;
};
constexpr float kDiagonal = 0.70710678F;
constexpr std::array<Step, 8> kSteps{{{1, 0, 1.0F, 1},
                                      {-1, 0, 1.0F, 0},
                                      {0, 1, 1.0F, 1},
                                      {0, -1, 1.0F, 0},
                                      {1, 1, kDiagonal, 1},
                                      {-1, 1, kDiagonal, 1},
                                      {1, -1, kDiagonal, 0},
                                      {-1, -1, kDiagonal, 0}}};

/// Heights and levels of a row and of those below and above, from column 0 on.
struct ThreeRows {
    std::array<const float*, 3> heights;
    std::array<const std::int32_t*, 3> levels;
};

/// By cell of the row in the middle, the steepest step up; 0 where all around are lower.
QUADCUT_WIDE_VECTORS void steepest_steps(const ThreeRows& rows, std::int32_t width,
                                         std::int32_t* ahead_of) {
    const auto [heights, levels] = rows;
    for (std::int32_t x = 0; x < width; ++x) {
        float steepest = -1e30F;
        std::int32_t ahead = 0;
        // The loop over the steps is unrolled, the one over cells done several at a time.
        for (const Step& step : kSteps) {
            const auto at = static_cast<std::size_t>(step.dy + 1);
            const float slope = (heights[at][x + step.dx] - heights[1][x]) * step.inverse_length;
            const bool is_higher = levels[at][x + step.dx] >= levels[1][x] + step.more;
            const bool is_steeper = is_higher & (slope > steepest);
            steepest = is_steeper ? slope : steepest;
            ahead = is_steeper ? step.dy * width + step.dx : ahead;
        }
        ahead_of[x] = ahead;
    }
}

/// Finds for each cell the neighbour to which it goes up most steeply, row by row.
class Ascent {
public:
    Ascent(const Raster<float>& clearance, const Rows& height, double resolution_m)
        : clearance_(clearance),
          height_(height),
          width_(height.stride - 2),
          scale_(static_cast<float>(64.0 / resolution_m)),
          outside_(height.stride, -1),
          ahead_(height.stride, 0) {
        for (std::vector<std::int32_t>& levels : levels_) levels.resize(height.stride, -1);
        if (height.first < height.last) level(height.first);
        if (height.first + 1 < height.last) level(height.first + 1);
    }

    /// The offset of that neighbour for the cells of row y, or of the cell itself where all are
    /// lower; kIsLabel where there is no clearance. Rows are asked for one after the other, from
    /// the second on if there is one before.
    void find(std::int64_t y, std::uint32_t* uphill) {
        if (y + 1 < height_.last) level(y + 1);
        // Rows outside have no level; their heights play no part.
        const auto height = [&](std::int64_t row) {
            return height_.row(row >= height_.first && row < height_.last ? row : y);
        };
        const std::array<const float*, 3> heights{height(y - 1), height(y), height(y + 1)};
        const std::array<const std::int32_t*, 3> levels{levels_of(y - 1), levels_of(y),
                                                        levels_of(y + 1)};
        const auto width = static_cast<std::int32_t>(width_);
        const auto row = static_cast<std::uint32_t>(static_cast<std::size_t>(y) * width_);
        steepest_steps({heights, levels}, width, ahead_.data());
        for (std::int32_t x = 0; x < width; ++x) {
            const std::uint32_t way = row + static_cast<std::uint32_t>(x + ahead_[x]);
            uphill[x] = levels[1][x] < 0 ? kIsLabel : way;
        }
    }
    /// Heights of a row in steps of 1/64 of a cell, from column 0 on; -1 where there is no
    /// clearance.
    [[nodiscard]] const std::int32_t* levels_of(std::int64_t y) const {
        const bool is_inside = y >= height_.first && y < height_.last;
        return 1 + (is_inside ? levels_[static_cast<std::size_t>(y) % levels_.size()] : outside_)
                       .data();
    }

private:
    void level(std::int64_t y) {
        std::int32_t* const out = levels_[static_cast<std::size_t>(y) % levels_.size()].data() + 1;
        const float* const height = height_.row(y);
        const float* const clearance =
            clearance_.values.data() + y * static_cast<std::int64_t>(width_);
        for (std::size_t x = 0; x < width_; ++x) {
            // Without a branch, so that several cells are done at a time.
            const std::int32_t is_closed = clearance[x] > 0.0F ? 0 : -1;
            out[x] = static_cast<std::int32_t>(height[x] * scale_) | is_closed;
        }
    }

    const Raster<float>& clearance_;
    const Rows& height_;
    std::size_t width_;
    float scale_;
    std::array<std::vector<std::int32_t>, 3> levels_;
    std::vector<std::int32_t> outside_;
    std::vector<std::int32_t> ahead_;
};

/// Where nothing goes up.
struct Peak {
    std::int32_t level = 0;
    std::uint32_t offset = 0;
};

std::vector<Peak> find_ways_up(const Raster<float>& clearance, double resolution_m,
                               const Executor& executor, std::uint32_t* ways) {
    const std::vector<float> kernel = gaussian_kernel(kSmoothingM / resolution_m);
    const auto width = static_cast<std::size_t>(clearance.width);
    const auto height = static_cast<std::size_t>(clearance.height);
    std::vector<std::vector<Peak>> found((height + kRowsPerChunk - 1) / kRowsPerChunk);
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        const auto begin = static_cast<std::int64_t>(first);
        const auto end = static_cast<std::int64_t>(last);
        const Rows smoothed =
            smooth(clearance, kernel, std::max<std::int64_t>(0, begin - 1),
                   std::min<std::int64_t>(static_cast<std::int64_t>(height), end + 1));
        Ascent ascent(clearance, smoothed, resolution_m);
        for (std::int64_t y = begin; y < end; ++y) {
            const auto row = static_cast<std::uint32_t>(static_cast<std::size_t>(y) * width);
            ascent.find(y, &ways[row]);
            for (std::uint32_t x = 0; x < width; ++x) {
                if (ways[row + x] != row + x) continue;
                found[first / kRowsPerChunk].push_back({ascent.levels_of(y)[x], row + x});
            }
        }
        // Up to the last cell of the own rows, so that no way is gone all along again and again.
        const auto low = static_cast<std::uint32_t>(first * width);
        const auto high = static_cast<std::uint32_t>(last * width);
        for (std::uint32_t i = low; i < high; ++i) {
            if ((ways[i] & kIsLabel) != 0) continue;
            std::uint32_t top = i;
            while (ways[top] != top && ways[top] >= low && ways[top] < high) top = ways[top];
            for (std::uint32_t at = i; at != top;) at = std::exchange(ways[at], ways[top]);
        }
    });
    std::vector<Peak> peaks;
    for (const std::vector<Peak>& part : found) peaks.insert(peaks.end(), part.begin(), part.end());
    return peaks;
}

}  // namespace

Basins build_basins(const Raster<float>& clearance_m, double resolution_m,
                    const Executor& executor) {
    Basins basins;
    if (clearance_m.values.size() >= kIsLabel) {
        throw InputError("the map has " + std::to_string(clearance_m.values.size()) +
                         " cells: expected fewer than " + std::to_string(kIsLabel));
    }
    basins.labels = Raster<std::uint32_t>::unset(clearance_m.box());
    if (clearance_m.values.empty()) return basins;
    auto& ways = basins.labels.values;
    std::vector<Peak> peaks = find_ways_up(clearance_m, resolution_m, executor, ways.data());
    // Basins are numbered from the highest peak down.
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const Peak& a, const Peak& b) { return a.level > b.level; });
    for (const Peak& peak : peaks) ways[peak.offset] = ++basins.count | kIsLabel;
    // Whether another thread has put a label in place of a way makes no difference.
    parallel_for(executor, ways.size(), kCellsPerChunk, [&](std::size_t first, std::size_t last) {
        const auto read = [&](std::size_t i) {
            return std::atomic_ref(ways[i]).load(std::memory_order_relaxed);
        };
        for (std::size_t i = first; i < last; ++i) {
            std::uint32_t top = read(i);
            if ((top & kIsLabel) != 0) continue;
            while ((top & kIsLabel) == 0) top = read(top);
            std::atomic_ref(ways[i]).store(top, std::memory_order_relaxed);
        }
    });
    parallel_for(executor, ways.size(), kCellsPerChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ways[i] &= ~kIsLabel;
    });
    return basins;
}

std::uint32_t split_at_lines(const WallLines& lines, Raster<std::uint32_t>& labels,
                             const Executor& executor) {
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (lines.more_dm.values[i] != 0) labels.values[i] = 0;
    }
    const ConnectedParts parts = connected_parts(
        labels, [&](std::size_t i) { return labels.values[i]; }, Connectivity::four, executor);
    std::vector<std::uint32_t> number(parts.count + std::size_t{1});
    std::iota(number.begin(), number.end(), 0U);
    parts.paint(number, labels, executor);
    return parts.count;
}

void spread_labels(const Raster<std::uint8_t>& open, Raster<std::uint32_t>& labels) {
    const auto width = static_cast<std::size_t>(labels.width);
    std::vector<std::size_t> front;
    const auto is_bare = [&](std::size_t i) {
        return open.values[i] != 0 && labels.values[i] == 0;
    };
    const auto for_each_neighbour = [&](std::size_t i, const auto& visit) {
        const std::size_t x = i % width;
        if (x > 0) visit(i - 1);
        if (x + 1 < width) visit(i + 1);
        if (i >= width) visit(i - width);
        if (i + width < labels.values.size()) visit(i + width);
    };
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (!is_bare(i)) continue;
        bool is_beside = false;
        for_each_neighbour(i, [&](std::size_t k) { is_beside |= labels.values[k] != 0; });
        if (is_beside) front.push_back(i);
    }
    while (!front.empty()) {
        // A cell is come by from all sides.
        std::sort(front.begin(), front.end());
        front.erase(std::unique(front.begin(), front.end()), front.end());
        std::vector<std::pair<std::size_t, std::uint32_t>> reached;
        for (const std::size_t i : front) {
            if (labels.values[i] != 0) continue;
            std::uint32_t label = 0;
            for_each_neighbour(i,
                               [&](std::size_t k) { label = std::max(label, labels.values[k]); });
            reached.emplace_back(i, label);
        }
        front.clear();
        for (const auto& [i, label] : reached) labels.values[i] = label;
        for (const auto& [i, label] : reached) {
            for_each_neighbour(i, [&](std::size_t k) {
                if (is_bare(k)) front.push_back(k);
            });
        }
    }
}

}  // namespace quadcut
