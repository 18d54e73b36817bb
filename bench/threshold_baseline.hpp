// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

namespace threshold_baseline_steps {

/// The parts of what is wider than a level, numbered from 1; parts that are too small for a
/// room stay 0. And how many there are.
inline std::pair<Raster<std::uint32_t>, std::uint32_t> parts_above(const Raster<float>& clearance,
                                                                   double level_m,
                                                                   std::size_t least_cells) {
    std::pair<Raster<std::uint32_t>, std::uint32_t> parts{
        {clearance.origin, clearance.width, clearance.height}, 0};
    std::vector<bool> seen(clearance.values.size(), false);
    const auto is_wide = [&](std::size_t i) {
        return static_cast<double>(clearance.values[i]) > level_m;
    };
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (seen[start] || !is_wide(start)) continue;
        const auto part = flood(clearance, start, seen, Connectivity::eight, is_wide);
        if (part.size() < least_cells) continue;
        ++parts.second;
        for (const std::size_t i : part) parts.first.values[i] = parts.second;
    }
    return parts;
}

/// Gives the rest of what is open to the nearest part, by the number of steps.
inline void spread(Raster<std::uint32_t>& labels, const Raster<std::uint8_t>& open) {
    std::deque<std::size_t> front;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (labels.values[i] != 0) front.push_back(i);
    }
    while (!front.empty()) {
        const std::size_t i = front.front();
        front.pop_front();
        for (const std::size_t next : Neighbours(labels, i, Connectivity::four)) {
            if (open.values[next] == 0 || labels.values[next] != 0) continue;
            labels.values[next] = labels.values[i];
            front.push_back(next);
        }
    }
}

}  // namespace threshold_baseline_steps

/// Rooms by the distance transform (Bormann et al. 2016, "Room segmentation: survey,
/// implementation, and analysis"): of all levels of clearance, the one above which there are most
/// parts of at least 0.35 m2 (as in their program); the rest goes to the nearest part.
[[nodiscard]] inline Raster<std::uint32_t> threshold_baseline(const GridMap& map) {
    using threshold_baseline_steps::parts_above;
    using threshold_baseline_steps::spread;
    constexpr double kLeastM2 = 0.35;
    constexpr double kStepM = 0.05;
    constexpr double kHighestM = 4.0;
    Raster<std::uint8_t> open(map.states.origin, map.states.width, map.states.height);
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        open.values[i] = map.states.values[i] == CellState::free ? 1 : 0;
    }
    const Raster<float> clearance = clearance_m(open, map.resolution_m);
    std::pair<Raster<std::uint32_t>, std::uint32_t> best;
    const auto least_cells =
        static_cast<std::size_t>(kLeastM2 / (map.resolution_m * map.resolution_m));
    for (double level = kHighestM; level > 0.5 * kStepM; level -= kStepM) {
        auto parts = parts_above(clearance, level, least_cells);
        if (best.first.values.empty() || parts.second > best.second) best = std::move(parts);
    }
    spread(best.first, open);
    return std::move(best.first);
}

}  // namespace quadcut
