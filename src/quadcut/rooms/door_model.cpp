// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/door_model.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "quadcut/rooms/door_trees.hpp"

namespace quadcut {
namespace {

constexpr double kLeast = 1e-3;
constexpr double kLeastHalfWidthM = 0.01;

float logarithm(double ratio) { return static_cast<float>(std::log(std::max(ratio, kLeast))); }

/// The region's length over its width, as if it were a rectangle.
double elongation(const SideOfSaddle& side) {
    return side.region_area_m2 / (4.0 * side.region_peak_m * side.region_peak_m);
}

/// A tree whose questions can all be asked at once: each that is answered with no, whether a path
/// comes by it or not, rules out the leaves below it, and the first leaf that is left is the tree's
/// (Lucchese et al., "QuickScorer", 2015). No jump to be foreseen wrongly: a follower, which asks
/// often, takes 2 % less time than by walking the trees.
struct FlatTree {
    struct Question {
        float threshold = 0.0F;
        std::uint8_t cue = 0;
        /// The leaves that are left after a no, as bits.
        std::uint8_t left = 0xFF;
    };
    std::array<Question, 5> questions;
    std::array<float, 6> leaves{};
};

/// The leaves under a node, which are numbered from below to above; notes the questions on the way.
unsigned flatten(const DoorTree& tree, int node, FlatTree& flat) {
    const auto leaf = [](int number) { return 1U << static_cast<unsigned>(-number); };
    const auto at = static_cast<std::size_t>(node);
    const DoorBranch& branch = tree.branches[at];
    const auto under = [&](int next) { return next > 0 ? flatten(tree, next, flat) : leaf(next); };
    const unsigned below = under(branch.below);
    // Not a question, but what fills a tree of one leaf.
    if (branch.below == branch.above) return below;
    flat.questions[at] = {branch.threshold, branch.cue, static_cast<std::uint8_t>(~below)};
    return below | under(branch.above);
}

std::array<FlatTree, kDoorTrees.size()> flat_trees() {
    std::array<FlatTree, kDoorTrees.size()> flat;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        flat[i].leaves = kDoorTrees[i].leaves;
        (void)flatten(kDoorTrees[i], 0, flat[i]);
    }
    return flat;
}

/// Over the leaves below what a branch leads to: their sum, and how many they are.
std::pair<double, int> leaves_under(const DoorTree& tree, int next) {
    if (next <= 0) return {tree.leaves[static_cast<std::size_t>(-next)], 1};
    const DoorBranch& branch = tree.branches[static_cast<std::size_t>(next)];
    const auto [below, num_below] = leaves_under(tree, branch.below);
    const auto [above, num_above] = leaves_under(tree, branch.above);
    return {below + above, num_below + num_above};
}

double mean_under(const DoorTree& tree, int next) {
    const auto [sum, count] = leaves_under(tree, next);
    return sum / count;
}

/// Cues one after the other, as kDoorCues lists them.
struct CueList {
    std::array<float, kNumDoorCues> cues{};
    std::size_t count = 0;

    void add(double value) { cues[count++] = static_cast<float>(value); }
    void add_logarithm(double ratio) { cues[count++] = logarithm(ratio); }
    void add_ratio(double of, double to) { add_logarithm(of / std::max(kLeast, to)); }
    /// First of the narrower side.
    template <typename Measure>
    void add_both(const Narrowing& narrowing, const Measure& measure) {
        add_logarithm(measure(narrowing.narrower));
        add_logarithm(measure(narrowing.wider));
    }

    void add_narrowing(const Narrowing& narrowing) {
        const double h = std::max(kLeastHalfWidthM, narrowing.half_width_m);
        const SideOfSaddle& narrower = narrowing.narrower;
        const SideOfSaddle& wider = narrowing.wider;
        const Opening& opening = narrowing.opening;
        add(narrowing.half_width_m);
        for (const double peak : narrower.peak_m) add_logarithm(peak / h);
        for (const double peak : wider.peak_m) add_logarithm(peak / h);
        add(narrower.reach_m / (2.0 * h));
        add(wider.reach_m / (2.0 * h));
        add_both(narrowing,
                 [h](const SideOfSaddle& side) { return side.area_m2[1] / (4.0 * h * h); });
        add_both(narrowing, [](const SideOfSaddle& side) { return side.area_m2[0]; });
        for (const double m : opening.thin_wall_m) add(m);
        for (const double m : opening.flush_wall_m) add(m);
        add(narrowing.border_ratio);
        for (const auto& side : opening.widening_m) {
            for (const double m : side) add(m);
        }
        add(opening.width_m);
        add_both(narrowing, [h](const SideOfSaddle& side) { return side.spread_m[0] / h; });
        add_logarithm(std::min(narrower.spread_m[0], wider.spread_m[0]) / h);
        add_logarithm(std::max(narrower.spread_m[0], wider.spread_m[0]) / h);
        add_both(narrowing, [h](const SideOfSaddle& side) { return side.spread_m[1] / h; });
        add_both(narrowing, [](const SideOfSaddle& side) { return side.region_area_m2; });
        add_both(narrowing, [h](const SideOfSaddle& side) { return side.region_peak_m / h; });
        add_both(narrowing, [](const SideOfSaddle& side) { return elongation(side); });
        add(static_cast<double>(narrower.num_openings));
        add(static_cast<double>(wider.num_openings));
        for (const double m : opening.line_of_walls_m) add(m);
    }
    void add_shape(const RegionShape& shape) {
        const Rectangle& around = shape.around_m;
        add(shape.area_m2 / std::max(kLeast, shape.hull_m2));
        add(around.width);
        add_ratio(around.length, around.width);
        add(shape.area_m2 / std::max(kLeast, around.width * around.length));
        add(shape.open_share);
        add(4.0 * shape.mean_clearance_m);
        add(4.0 * shape.mean_free_clearance_m);
    }
};

}  // namespace

std::array<float, kNumDoorCues> door_cues(const BorderMeasure& border) {
    CueList list;
    for (const Narrowing* narrowing : {&border.narrowing, &border.free_narrowing}) {
        list.add_narrowing(*narrowing);
    }
    for (const Narrowing* narrowing : {&border.narrowing, &border.free_narrowing}) {
        list.add(narrowing->share_in_line);
        list.add(narrowing->less_wall_m);
        list.add(narrowing->more_wall_m);
    }
    for (const RegionShape* shape : {&border.narrower, &border.wider, &border.joined}) {
        list.add_shape(*shape);
    }
    list.add_ratio(border.narrower.mean_clearance_m, border.wider.mean_clearance_m);
    list.add_ratio(border.joined.hull_m2, border.narrower.hull_m2 + border.wider.hull_m2);
    for (const double m : border.open_in_line_m) list.add(m);
    for (const double m : border.free_in_line_m) list.add(m);
    return list.cues;
}

double door_log_odds(const BorderMeasure& border) {
    static const std::array<FlatTree, kDoorTrees.size()> trees = flat_trees();
    const std::array<float, kNumDoorCues> cues = door_cues(border);
    double log_odds = kDoorBias;
    for (const FlatTree& tree : trees) {
        unsigned leaves = 0xFF;
        for (const FlatTree::Question& question : tree.questions) {
            const bool is_yes = cues[question.cue] <= question.threshold;
            leaves &= question.left | -static_cast<unsigned>(is_yes);
        }
        log_odds +=
            static_cast<double>(tree.leaves[static_cast<std::size_t>(std::countr_zero(leaves))]);
    }
    return log_odds;
}

std::array<double, kNumDoorCues> door_contributions(const BorderMeasure& border) {
    const std::array<float, kNumDoorCues> cues = door_cues(border);
    std::array<double, kNumDoorCues> contributions{};
    for (const DoorTree& tree : kDoorTrees) {
        const DoorBranch* branch = &tree.branches[0];
        double mean =
            (leaves_under(tree, branch->below).first + leaves_under(tree, branch->above).first) /
            (leaves_under(tree, branch->below).second + leaves_under(tree, branch->above).second);
        while (branch->below != branch->above) {
            const int next = cues[branch->cue] <= branch->threshold ? branch->below : branch->above;
            const double mean_after = mean_under(tree, next);
            contributions[branch->cue] += mean_after - mean;
            mean = mean_after;
            if (next <= 0) break;
            branch = &tree.branches[static_cast<std::size_t>(next)];
        }
    }
    return contributions;
}

}  // namespace quadcut
