// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>

#include "quadcut/base/random.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

// Changes of a map that change no room.
namespace quadcut {

/// A cell takes what this many samples a side find in it.
inline constexpr int kSamples = 4;
/// The share of known cells that noise flips.
inline constexpr double kNoise = 0.005;

/// Where each point of the changed image is in the unchanged one, both in cells.
struct Resampling {
    std::int32_t width = 0;
    std::int32_t height = 0;
    double resolution_m = 0.0;
    /// The changed image's point in the unchanged one.
    std::function<Point(const Point&)> source;
};

inline Cell cell_of(const Point& point) {
    return {static_cast<std::int32_t>(std::floor(point.x)),
            static_cast<std::int32_t>(std::floor(point.y))};
}

/// Of all that a cell covers an obstacle wins, then what is unknown; outside nothing is known.
inline GridMap resample(const GridMap& map, const Resampling& change) {
    GridMap changed{change.resolution_m, {}, {{0, 0}, change.width, change.height}};
    for (std::size_t i = 0; i < changed.states.values.size(); ++i) {
        const Cell cell = changed.states.cell(i);
        CellState state = CellState::free;
        for (int sample = 0; sample < kSamples * kSamples; ++sample) {
            const int row = sample / kSamples;
            const int column = sample % kSamples;
            const Cell source = cell_of(change.source(
                {cell.x + (column + 0.5) / kSamples, cell.y + (row + 0.5) / kSamples}));
            const CellState at =
                map.states.contains(source) ? map.states.at(source) : CellState::unknown;
            if (at == CellState::occupied || state == CellState::free) state = at;
        }
        changed.states.values[i] = state;
    }
    return changed;
}

/// Each cell takes the label at its centre.
template <typename Label>
Raster<Label> resample_nearest(const Raster<Label>& labels, const Resampling& change) {
    Raster<Label> changed({0, 0}, change.width, change.height);
    for (std::size_t i = 0; i < changed.values.size(); ++i) {
        const Cell cell = changed.cell(i);
        const Cell source = cell_of(change.source({cell.x + 0.5, cell.y + 0.5}));
        if (labels.contains(source)) changed.values[i] = labels.at(source);
    }
    return changed;
}

inline Resampling turned(const GridMap& map, double degrees) {
    const double width = map.states.width;
    const double height = map.states.height;
    const double c = std::cos(degrees * std::numbers::pi / 180.0);
    const double s = std::sin(degrees * std::numbers::pi / 180.0);
    // Less than a thousandth of a cell is rounding.
    const auto side = [](double cells) {
        return static_cast<std::int32_t>(std::ceil(cells - 1e-3));
    };
    Resampling change{side(width * std::abs(c) + height * std::abs(s)),
                      side(width * std::abs(s) + height * std::abs(c)),
                      map.resolution_m,
                      {}};
    const Point middle{0.5 * change.width, 0.5 * change.height};
    change.source = [=](const Point& at) {
        const double x = at.x - middle.x;
        const double y = at.y - middle.y;
        return Point{0.5 * width + c * x + s * y, 0.5 * height - s * x + c * y};
    };
    return change;
}

inline Resampling mirrored(const GridMap& map) {
    const std::int32_t width = map.states.width;
    return {width, map.states.height, map.resolution_m, [width](const Point& at) {
                return Point{width - at.x, at.y};
            }};
}

/// `cells` cells of the changed map are as long as one of the unchanged.
inline Resampling scaled(const GridMap& map, double cells) {
    return {static_cast<std::int32_t>(std::ceil(map.states.width * cells)),
            static_cast<std::int32_t>(std::ceil(map.states.height * cells)),
            map.resolution_m / cells, [cells](const Point& at) {
                return Point{at.x / cells, at.y / cells};
            }};
}

/// More cells at the lower left and at the upper right.
inline Resampling padded(const GridMap& map, std::int32_t before, std::int32_t after) {
    return {map.states.width + before + after, map.states.height + before + after, map.resolution_m,
            [before](const Point& at) {
                return Point{at.x - before, at.y - before};
            }};
}

/// Flips known cells: free becomes occupied and the other way round.
inline GridMap with_noise(const GridMap& map) {
    GridMap noisy = map;
    Random random(1);
    for (CellState& state : noisy.states.values) {
        if (state == CellState::unknown || random.uniform() >= kNoise) continue;
        state = state == CellState::free ? CellState::occupied : CellState::free;
    }
    return noisy;
}

}  // namespace quadcut
