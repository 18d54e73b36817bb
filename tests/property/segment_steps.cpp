// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The steps of the cut against plain versions of themselves, on random floors.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/door_model.hpp"
#include "quadcut/rooms/door_trees.hpp"
#include "quadcut/rooms/narrowing.hpp"
#include "quadcut/rooms/open_space.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

/// Rectangles of free space, and specks of obstacles in them.
Raster<std::uint8_t> random_floor(Random& random, std::int32_t width, std::int32_t height) {
    Raster<std::uint8_t> open({0, 0}, width, height);
    for (int k = 0; k < 12; ++k) {
        const auto x0 = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(width)));
        const auto y0 = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(height)));
        const auto x1 = std::min(width, x0 + 10 + static_cast<std::int32_t>(random.below(50)));
        const auto y1 = std::min(height, y0 + 10 + static_cast<std::int32_t>(random.below(50)));
        for (std::int32_t y = y0; y < y1; ++y) {
            for (std::int32_t x = x0; x < x1; ++x) open.at({x, y}) = 1;
        }
    }
    for (std::uint8_t& cell : open.values) cell = random.below(200) == 0 ? 0 : cell;
    return open;
}

/// Cells from the highest down; each joins the steepest labelled neighbour, or begins a basin.
Raster<std::uint32_t> basins_one_by_one(const Raster<float>& clearance, double resolution_m) {
    const auto width = clearance.width;
    // The same kernel: sigma 0.05 m, three sigma far.
    const double sigma = 0.05 / resolution_m;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<float> kernel;
    for (int i = -radius; i <= radius; ++i) {
        kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    }
    const float sum = std::accumulate(kernel.begin(), kernel.end(), 0.0F);
    for (float& k : kernel) k /= sum;
    const auto smooth = [&](const Raster<float>& in, Cell step) {
        Raster<float> out(in.origin, in.width, in.height);
        for (int k = -radius; k <= radius; ++k) {
            for (std::size_t i = 0; i < out.values.size(); ++i) {
                const Cell at = in.cell(i);
                const Cell from{at.x + k * step.x, at.y + k * step.y};
                if (!in.contains(from)) continue;
                out.values[i] += kernel[static_cast<std::size_t>(k + radius)] * in.at(from);
            }
        }
        return out;
    };
    const Raster<float> height = smooth(smooth(clearance, {1, 0}), {0, 1});
    const auto scale = static_cast<float>(64.0 / resolution_m);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < height.values.size(); ++i) {
        if (clearance.values[i] > 0.0F) order.push_back(i);
    }
    const auto level = [&](std::size_t i) { return static_cast<int>(height.values[i] * scale); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return level(a) > level(b); });
    constexpr std::array<Cell, 8> kSteps{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    Raster<std::uint32_t> labels(clearance.origin, width, clearance.height);
    std::uint32_t count = 0;
    for (const std::size_t i : order) {
        const Cell at = labels.cell(i);
        float steepest = -1e30F;
        std::uint32_t uphill = 0;
        for (const Cell step : kSteps) {
            const Cell next{at.x + step.x, at.y + step.y};
            if (!labels.contains(next) || labels.at(next) == 0) continue;
            const float length = step.x != 0 && step.y != 0 ? 0.70710678F : 1.0F;
            const float slope = (height.at(next) - height.values[i]) * length;
            if (slope <= steepest) continue;
            steepest = slope;
            uphill = labels.at(next);
        }
        labels.values[i] = uphill != 0 ? uphill : ++count;
    }
    return labels;
}

TEST(SegmentSteps, BasinsAreThoseOfCellsTakenFromTheHighestDown) {
    Random random(11);
    for (int round = 0; round < 12; ++round) {
        const auto height = static_cast<std::int32_t>(60 + random.below(150));
        const auto open = random_floor(random, 150, height);
        const Raster<float> clearance = clearance_m(open, 0.05);
        const Basins basins = build_basins(clearance, 0.05, {2});
        ASSERT_EQ(basins.labels.values, basins_one_by_one(clearance, 0.05).values) << round;
    }
}

/// Every neighbour looked at, by Dijkstra; steps of two cells at 5 cm, 5 and 7 fifths long.
SideOfSaddle walk_plainly(const Raster<float>& clearance, const Raster<std::uint32_t>& regions,
                          Cell seed, const Direction& along) {
    using Entry = std::tuple<int, int, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    Raster<int> length({-60, -60}, 121, 121, 1 << 20);
    length.at({0, 0}) = 0;
    queue.push({0, 0, 0});
    SideOfSaddle side;
    std::array<double, 3> within{1.5, 3.0, 5.0};
    std::array<std::vector<double>, 3> asides;
    while (!queue.empty()) {
        const auto [path, x, y] = queue.top();
        queue.pop();
        if (path != length.at({x, y})) continue;
        const double path_m = path * 0.1 / 5.0;
        if (path_m > 5.0) break;
        const double clear = static_cast<double>(clearance.at({seed.x + 2 * x, seed.y + 2 * y}));
        side.reach_m = path_m;
        for (std::size_t i = 0; i < 3; ++i) {
            if (path_m > within[i]) continue;
            side.peak_m[i] = std::max(side.peak_m[i], clear);
            asides[i].push_back(x * along.x + y * along.y);
        }
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell next{seed.x + 2 * (x + dx), seed.y + 2 * (y + dy)};
                if (!regions.contains(next) || regions.at(next) != regions.at(seed)) continue;
                const int longer = path + (dx != 0 && dy != 0 ? 7 : 5);
                if (longer >= length.at({x + dx, y + dy})) continue;
                length.at({x + dx, y + dy}) = longer;
                queue.push({longer, x + dx, y + dy});
            }
        }
    }
    for (std::size_t i = 1; i < 3; ++i) {
        const auto count = static_cast<double>(asides[i].size());
        side.area_m2[i - 1] = count * 0.01;
        side.spread_m[i - 1] = std::sqrt(std::inner_product(asides[i].begin(), asides[i].end(),
                                                            asides[i].begin(), 0.0) /
                                         count) *
                               0.1;
    }
    return side;
}

void expect_same(const SideOfSaddle& a, const SideOfSaddle& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(a.peak_m[i], b.peak_m[i]);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(a.area_m2[i], b.area_m2[i], 1e-9);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(a.spread_m[i], b.spread_m[i], 1e-9);
    EXPECT_NEAR(a.reach_m, b.reach_m, 1e-9);
}

TEST(SegmentSteps, AWalkThatLooksOnlyWhereItMustFindsAllThatAPlainOneDoes) {
    Random random(12);
    int num_walks = 0;
    while (num_walks < 90) {
        // Around some seeds the whole window lies inside, around others it does not.
        const bool is_large = num_walks % 30 >= 20;
        const auto open =
            is_large ? random_floor(random, 330, 290) : random_floor(random, 160, 120);
        const Raster<float> clearance = clearance_m(open, 0.05);
        const Basins basins = build_basins(clearance, 0.05);
        std::vector<std::uint32_t> region(basins.count + std::size_t{1});
        std::iota(region.begin(), region.end(), 0U);
        // A few basins in one, so that walks go around corners.
        for (std::uint32_t piece = 1; piece < region.size(); ++piece) {
            if (random.below(3) != 0) region[piece] = 1;
        }
        Raster<std::uint32_t> regions = basins.labels;
        for (std::uint32_t& label : regions.values) label = region[label];
        NarrowingGauge gauge(clearance, clearance, 0.05);
        for (int k = 0; k < 10; ++k) {
            const std::size_t seed = random.below(regions.values.size());
            if (regions.values[seed] == 0) continue;
            const double angle = random.uniform(0.0, 3.0);
            const Direction along{std::cos(angle), std::sin(angle)};
            const Cell cell = regions.cell(seed);
            expect_same(
                side_of(gauge.walk_outward(cell, {basins.labels, region}), Among::all, along),
                walk_plainly(clearance, regions, cell, along));
            ++num_walks;
        }
    }
}

TEST(SegmentSteps, BasinsOfAMapNarrowerThanItsSmoothing) {
    for (const std::int32_t width : {1, 2, 3}) {
        const Raster<std::uint8_t> open({0, 0}, width, 40, 1);
        const Basins basins = build_basins(clearance_m(open, 0.005), 0.005);
        EXPECT_GE(basins.count, 1U);
        EXPECT_EQ(std::count(basins.labels.values.begin(), basins.labels.values.end(), 0U), 0);
    }
}

TEST(SegmentSteps, OpenSpaceIsTheSameWhereverItLies) {
    Random random(8);
    for (const double resolution_m : {0.005, 0.05, 1.0}) {
        const double max_m2 = 60.0 * resolution_m * resolution_m;
        for (int k = 0; k < 6; ++k) {
            Raster<std::uint8_t> floor = random_floor(random, 160, 120);
            constexpr Cell kAway{1003, 2005};
            Raster<std::uint8_t> away({0, 0}, 1203, 2155);
            for (std::size_t i = 0; i < floor.values.size(); ++i) {
                const Cell cell = floor.cell(i);
                // What touches the edge of a map is no furniture: the same in both.
                if (is_on_edge(floor, i)) floor.values[i] = 0;
                away.at({cell.x + kAway.x, cell.y + kAway.y}) = floor.values[i];
            }
            const auto here = open_space(floor, resolution_m, max_m2, {});
            const auto there = open_space(away, resolution_m, max_m2, {});
            for (std::size_t i = 0; i < here.values.size(); ++i) {
                const Cell cell = here.cell(i);
                ASSERT_EQ(here.values[i], there.at({cell.x + kAway.x, cell.y + kAway.y}));
                ASSERT_GE(here.values[i], floor.values[i]);
            }
        }
    }
}

/// Question by question from the root.
double leaf_of(const DoorTree& tree, const std::array<float, kNumDoorCues>& cues) {
    int node = 0;
    do {
        const DoorBranch& branch = tree.branches[static_cast<std::size_t>(node)];
        node = cues[branch.cue] <= branch.threshold ? branch.below : branch.above;
    } while (node > 0);
    return static_cast<double>(tree.leaves[static_cast<std::size_t>(-node)]);
}

TEST(SegmentSteps, TreesAskedAllAtOnceAnswerAsTreesThatAreWalked) {
    Random random(5);
    const auto side = [&] {
        SideOfSaddle out;
        for (double& peak : out.peak_m) peak = random.uniform(0.1, 4.0);
        for (double& area : out.area_m2) area = random.uniform(0.0, 50.0);
        for (double& spread : out.spread_m) spread = random.uniform(0.0, 3.0);
        out.reach_m = random.uniform(0.0, 5.0);
        out.region_area_m2 = random.uniform(0.1, 200.0);
        out.region_peak_m = random.uniform(0.1, 5.0);
        out.num_openings = random.below(20);
        return out;
    };
    for (int k = 0; k < 500; ++k) {
        Narrowing narrowing;
        narrowing.half_width_m = random.uniform(0.05, 2.0);
        narrowing.narrower = side();
        narrowing.wider = side();
        narrowing.border_ratio = random.uniform(0.5, 5.0);
        Opening& opening = narrowing.opening;
        opening.width_m = random.uniform(0.1, 4.0);
        for (double& wall : opening.thin_wall_m) wall = random.uniform(0.0, 0.6);
        for (double& wall : opening.flush_wall_m) wall = random.uniform(0.0, 0.6);
        for (double& wall : opening.line_of_walls_m) wall = random.uniform(0.0, 6.0);
        for (auto& widening : opening.widening_m) {
            for (double& jamb : widening) jamb = random.uniform(0.0, 1.5);
        }
        const BorderMeasure border = test::plain_border(narrowing);
        const std::array<float, kNumDoorCues> cues = door_cues(border);
        double log_odds = kDoorBias;
        for (const DoorTree& tree : kDoorTrees) log_odds += leaf_of(tree, cues);
        ASSERT_EQ(door_log_odds(border), log_odds);
    }
}

TEST(SegmentSteps, WhatIsNotMeasuredAgainAfterAJoinWouldMeasureTheSame) {
    Random random(13);
    int num_compared = 0;
    for (int round = 0; round < 6; ++round) {
        const auto open = random_floor(random, 200, 150);
        const Raster<float> clearance = clearance_m(open, 0.05);
        const Basins basins = build_basins(clearance, 0.05);
        const test::PlainGround plain(clearance, 0.05);
        RegionGraph regions(basins.labels, basins.count, plain.ground());
        NarrowingGauge gauge = plain.gauge();
        for (int join = 0; join < 30; ++join) {
            std::vector<std::uint32_t> with_neighbours;
            for (std::uint32_t piece = 1; piece <= basins.count; ++piece) {
                if (regions.is_region(piece) && !regions.saddles(piece).empty()) {
                    with_neighbours.push_back(piece);
                }
            }
            if (with_neighbours.empty()) break;
            std::vector<RegionPair> pairs;
            for (const std::uint32_t region : with_neighbours) {
                for (const auto& [other, saddle] : regions.saddles(region)) {
                    if (region < other) pairs.emplace_back(region, other);
                }
            }
            regions.look_at(pairs, {2});
            const std::uint32_t a = with_neighbours[random.below(with_neighbours.size())];
            const auto& saddles = regions.saddles(a);
            auto chosen = saddles.begin();
            std::advance(chosen, static_cast<std::ptrdiff_t>(random.below(saddles.size())));
            regions.join(a, chosen->first);
            for (const auto& [other, saddle] : regions.saddles(a)) {
                const Saddle& from_lower =
                    regions.saddles(std::min(a, other)).at(std::max(a, other));
                const Narrowing kept = regions.measure(a, other).narrowing;
                const Narrowing anew =
                    regions.measure_at(from_lower, from_lower, std::minmax(a, other), gauge)
                        .narrowing;
                EXPECT_EQ(kept.is_a_narrower, anew.is_a_narrower);
                expect_same(kept.narrower, anew.narrower);
                expect_same(kept.wider, anew.wider);
                EXPECT_EQ(kept.opening.jambs, anew.opening.jambs);
                EXPECT_DOUBLE_EQ(kept.border_ratio, anew.border_ratio);
                ++num_compared;
            }
        }
    }
    EXPECT_GT(num_compared, 100);
}

TEST(SegmentSteps, RunsAreJoinedAsAFloodJoinsCells) {
    Random random(14);
    for (int round = 0; round < 40; ++round) {
        const auto width = static_cast<std::int32_t>(1 + random.below(90));
        const auto height = static_cast<std::int32_t>(1 + random.below(90));
        Raster<std::uint8_t> keys({3, -5}, width, height);
        for (std::uint8_t& key : keys.values) key = static_cast<std::uint8_t>(random.below(3));
        for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
            const ConnectedParts parts = connected_parts(
                keys, [&](std::size_t i) { return keys.values[i]; }, connectivity, {2});
            std::vector<std::uint32_t> own(parts.count + std::size_t{1});
            std::iota(own.begin(), own.end(), 0U);
            Raster<std::uint32_t> labels({3, -5}, width, height);
            parts.paint(own, labels);
            std::vector<bool> seen(keys.values.size(), false);
            const std::vector<bool> on_edge = parts.on_edge();
            const std::vector<std::size_t> num_cells = parts.num_cells();
            std::uint32_t part = 0;
            for (std::size_t i = 0; i < keys.values.size(); ++i) {
                const Cell at{keys.cell(i).x - 3, keys.cell(i).y + 5};
                ASSERT_EQ(
                    parts.part_at(static_cast<std::uint32_t>(at.x), static_cast<std::size_t>(at.y)),
                    labels.values[i]);
                if (keys.values[i] == 0 || seen[i]) continue;
                ++part;
                bool is_on_rim = false;
                const auto cells = flood(keys, i, seen, connectivity, [&](std::size_t j) {
                    return keys.values[j] == keys.values[i];
                });
                for (const std::size_t cell : cells) {
                    ASSERT_EQ(labels.values[cell], part);
                    is_on_rim = is_on_rim || is_on_edge(keys, cell);
                }
                ASSERT_EQ(num_cells[part], cells.size());
                ASSERT_EQ(on_edge[part], is_on_rim);
            }
            ASSERT_EQ(part, parts.count);
        }
    }
}

}  // namespace
}  // namespace quadcut
