// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/door_model.hpp"

#include <algorithm>
#include <cmath>

#include "quadcut/rooms/door_trees.hpp"

namespace quadcut {
namespace {

constexpr double kLeast = 1e-3;

float logarithm(double ratio) { return static_cast<float>(std::log(std::max(ratio, kLeast))); }

/// The region's length over its width, as if it were a rectangle.
double elongation(const SideOfSaddle& side) {
    return side.region_area_m2 / (4.0 * side.region_peak_m * side.region_peak_m);
}

float answer(const DoorTree& tree, const std::array<float, kNumDoorCues>& cues) {
    int next = 0;
    do {
        const DoorBranch& branch = tree.branches[static_cast<std::size_t>(next)];
        next = cues[branch.cue] <= branch.threshold ? branch.below : branch.above;
    } while (next > 0);
    return tree.leaves[static_cast<std::size_t>(-next)];
}

}  // namespace

std::array<float, kNumDoorCues> door_cues(const Narrowing& narrowing) {
    const double h = narrowing.half_width_m;
    const SideOfSaddle& narrower = narrowing.narrower;
    const SideOfSaddle& wider = narrowing.wider;
    const Opening& opening = narrowing.opening;
    return {static_cast<float>(h),
            logarithm(narrower.peak_m[0] / h),
            logarithm(narrower.peak_m[1] / h),
            logarithm(narrower.peak_m[2] / h),
            logarithm(wider.peak_m[0] / h),
            logarithm(wider.peak_m[1] / h),
            logarithm(wider.peak_m[2] / h),
            static_cast<float>(narrower.reach_m / (2.0 * h)),
            static_cast<float>(wider.reach_m / (2.0 * h)),
            logarithm(narrower.area_m2[1] / (4.0 * h * h)),
            logarithm(wider.area_m2[1] / (4.0 * h * h)),
            logarithm(narrower.area_m2[0]),
            logarithm(wider.area_m2[0]),
            static_cast<float>(opening.thin_wall_m[0]),
            static_cast<float>(opening.thin_wall_m[1]),
            static_cast<float>(opening.flush_wall_m[0]),
            static_cast<float>(opening.flush_wall_m[1]),
            static_cast<float>(narrowing.border_ratio),
            static_cast<float>(opening.widening_m[0][0]),
            static_cast<float>(opening.widening_m[0][1]),
            static_cast<float>(opening.widening_m[1][0]),
            static_cast<float>(opening.widening_m[1][1]),
            static_cast<float>(opening.width_m),
            logarithm(narrower.spread_m[0] / h),
            logarithm(wider.spread_m[0] / h),
            logarithm(std::min(narrower.spread_m[0], wider.spread_m[0]) / h),
            logarithm(std::max(narrower.spread_m[0], wider.spread_m[0]) / h),
            logarithm(narrower.spread_m[1] / h),
            logarithm(wider.spread_m[1] / h),
            logarithm(narrower.region_area_m2),
            logarithm(wider.region_area_m2),
            logarithm(narrower.region_peak_m / h),
            logarithm(wider.region_peak_m / h),
            logarithm(elongation(narrower)),
            logarithm(elongation(wider)),
            static_cast<float>(narrower.num_openings),
            static_cast<float>(wider.num_openings),
            static_cast<float>(opening.line_of_walls_m[0]),
            static_cast<float>(opening.line_of_walls_m[1])};
}

double door_log_odds(const Narrowing& narrowing) {
    const std::array<float, kNumDoorCues> cues = door_cues(narrowing);
    double log_odds = kDoorBias;
    for (const DoorTree& tree : kDoorTrees) log_odds += static_cast<double>(answer(tree, cues));
    return log_odds;
}

}  // namespace quadcut
