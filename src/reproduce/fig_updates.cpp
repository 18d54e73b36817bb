// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Fig 13: what a scan reaches.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/map/tile.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/kd_tree.hpp"
#include "reproduce/plot.hpp"
#include "reproduce/sentence.hpp"
#include "reproduce/timing.hpp"

namespace quadcut::reproduce {
namespace {

constexpr double kShortRangeM = 4.0;
constexpr double kQuarter = 0.25;
constexpr std::size_t kNumTrees = 40;

/// What laying a world's scans into the quadtree costs.
struct Updates {
    /// Over scans, percent.
    std::vector<Point> ps;
    std::vector<Point> touched;
    std::vector<Point> rebuilt;
    std::vector<Point> rebuilt_nodes;
    std::vector<Point> update_ms;
    std::vector<Point> kd_tree_ms;
    std::vector<Point> kd_tree_nodes;
    /// Scans of which the observation lies on both sides of a middle line of the tree's root.
    std::size_t num_crossing = 0;
    double ps_when_crossing = 0.0;
};

/// Whether what a scan speaks of lies on both sides of a line that halves the root.
bool crosses_middle(const MapUpdate& update, const Root& root) {
    Box tiles;
    for (const Cell tile : update.observed) tiles.include({tile, tile});
    const Box seen = cells_of_tiles(tiles);
    const Cell middle{root.lower_left.x + root.side_cells() / 2,
                      root.lower_left.y + root.side_cells() / 2};
    return (seen.low.x < middle.x && seen.high.x >= middle.x) ||
           (seen.low.y < middle.y && seen.high.y >= middle.y);
}

Updates lay_in(const World& world, const IntegrateOptions& options, bool with_trees) {
    Updates result;
    OccupancyMap map(kResolutionM);
    const std::size_t sample = std::max<std::size_t>(1, world.scans.size() / kNumTrees);
    for (std::size_t i = 0; i < world.scans.size(); ++i) {
        const auto at = static_cast<double>(i + 1);
        MapUpdate update;
        const double ms =
            elapsed_ms([&] { update = integrate_scan(map, world.scans[i], options); });
        if (!update.covering) continue;
        const auto all = static_cast<double>(map.num_nodes());
        const double ps = static_cast<double>(map.num_nodes_in(*update.covering)) / all;
        result.ps.push_back({at, 100.0 * ps});
        result.touched.push_back({at, 100.0 * static_cast<double>(update.nodes_touched) / all});
        const auto rebuilt = static_cast<double>(update.nodes_rebuilt);
        result.rebuilt.push_back({at, 100.0 * rebuilt / all});
        result.rebuilt_nodes.push_back({at, rebuilt});
        result.update_ms.push_back({at, ms});
        if (crosses_middle(update, map.root())) {
            ++result.num_crossing;
            result.ps_when_crossing += 100.0 * ps;
        }
        if (with_trees && (i + 1) % sample == 0) {
            const std::vector<Cell> points = obstacles_of(map);
            result.kd_tree_nodes.push_back({at, static_cast<double>(points.size())});
            // A scan goes in once only; a tree can be built again, and the least time counts.
            result.kd_tree_ms.push_back(
                {at, least_ms(3, {[&] { build_kd_tree(points); }}).front()});
        }
    }
    if (result.num_crossing > 0) {
        result.ps_when_crossing /= static_cast<double>(result.num_crossing);
    }
    return result;
}

double highest(const std::vector<Point>& points) {
    double value = 0.0;
    for (const Point& point : points) value = std::max(value, point.y);
    return value;
}

/// Percent of the scans with a ps of at most a quarter.
double percent_below_quarter(const Updates& updates) {
    const auto below = std::count_if(updates.ps.begin(), updates.ps.end(), [](const Point& point) {
        return point.y <= 100.0 * kQuarter;
    });
    return 100.0 * static_cast<double>(below) /
           static_cast<double>(std::max<std::size_t>(1, updates.ps.size()));
}

/// Fig 13 on one world.
struct WorldCost {
    std::string name;
    Updates updates;
    double percent_below = 0.0;
    double percent_below_near = 0.0;
    double median_touched = 0.0;
    double median_rebuilt = 0.0;
    double update_ms = 0.0;
    double tree_ms = 0.0;
};

WorldCost cost_of(const World& world) {
    IntegrateOptions short_range = latest_scan_wins();
    short_range.usable_range_m = kShortRangeM;
    WorldCost cost;
    cost.name = world.name;
    cost.updates = lay_in(world, latest_scan_wins(), true);
    cost.percent_below = percent_below_quarter(cost.updates);
    cost.percent_below_near = percent_below_quarter(lay_in(world, short_range, false));
    cost.median_touched = median(heights(cost.updates.touched));
    cost.median_rebuilt = median(heights(cost.updates.rebuilt));
    cost.update_ms = median(heights(cost.updates.update_ms));
    cost.tree_ms = median(heights(cost.updates.kd_tree_ms));
    return cost;
}

Table table_of(const std::vector<WorldCost>& costs) {
    Table table{"",
                {"the paper"},
                {{"ps when the middle is crossed", "%", {words("100")}},
                 {"scans with ps of at most 25 %", "%", {words("many")}},
                 {"the same, laser limited to 4 m", "%", {none()}},
                 {"nodes rebuilt, median", "%", {words("less than 25")}},
                 {"nodes touched, median", "%", {none()}},
                 {"nodes rebuilt, mean", "", {none()}},
                 {"KD-tree: nodes rebuilt, mean", "", {words("all")}},
                 {"quadtree, one scan, median", "ms", {none()}},
                 {"KD-tree built anew, median", "ms", {none()}}}};
    for (const WorldCost& cost : costs) {
        table.columns.push_back(cost.name);
        const std::vector<Value> values{cost.updates.num_crossing > 0
                                            ? number(cost.updates.ps_when_crossing, 1)
                                            : words("never"),
                                        number(cost.percent_below, 1),
                                        number(cost.percent_below_near, 1),
                                        number(cost.median_rebuilt, 2),
                                        number(cost.median_touched, 2),
                                        number(mean(cost.updates.rebuilt_nodes)),
                                        number(mean(cost.updates.kd_tree_nodes)),
                                        number(cost.update_ms, 3),
                                        number(cost.tree_ms, 3)};
        for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].values.push_back(values[i]);
    }
    return table;
}

std::vector<Picture> pictures_of(const std::vector<WorldCost>& costs) {
    std::vector<Picture> pictures;
    for (const WorldCost& cost : costs) {
        const double end = cost.updates.ps.empty() ? 1.0 : cost.updates.ps.back().x;
        const Plot plot{cost.name + ": ps over time",
                        "scan",
                        "%",
                        {{"ps", cost.updates.ps, CurveStyle::dots},
                         {"nodes rebuilt", cost.updates.rebuilt, CurveStyle::dots},
                         {"KD-tree: all", {{0.0, 100.0}, {end, 100.0}}}},
                        100.0};
        pictures.push_back({"fig13_" + std::to_string(pictures.size() + 1) + ".svg", to_svg(plot),
                            cost.name + ": each dot is a scan"});
    }
    const WorldCost& last = costs.back();
    const Plot nodes{last.name + ": nodes that are made anew",
                     "scan",
                     "nodes",
                     {{"quadtree, one scan", last.updates.rebuilt_nodes, CurveStyle::dots},
                      {"KD-tree: all", last.updates.kd_tree_nodes}},
                     1.25 * highest(last.updates.kd_tree_nodes)};
    pictures.push_back({"fig13_nodes.svg", to_svg(nodes), last.name + ": nodes rebuilt by number"});
    const Plot plot{last.name + ": time of an update",
                    "scan",
                    "ms",
                    {{"quadtree, one scan", last.updates.update_ms, CurveStyle::dots},
                     {"KD-tree built anew", last.updates.kd_tree_ms}},
                    1.25 * highest(last.updates.kd_tree_ms)};
    pictures.push_back({"fig13_times.svg", to_svg(plot),
                        last.name + ": wall time; what took longer is drawn at the top"});
    return pictures;
}

UpdateNumbers numbers_of(const std::vector<WorldCost>& costs) {
    UpdateNumbers numbers;
    for (const WorldCost& cost : costs) {
        if (cost.updates.num_crossing > 0) {
            numbers.ps_crossing.push_back({cost.name, cost.updates.ps_when_crossing});
        }
        numbers.percent_below.push_back({cost.name, cost.percent_below});
        numbers.rebuilt_percent.push_back({cost.name, cost.median_rebuilt});
        numbers.tree_over_rebuilt.push_back(
            {cost.name, mean(cost.updates.kd_tree_nodes) / mean(cost.updates.rebuilt_nodes)});
        numbers.tree_over_scan.push_back({cost.name, cost.tree_ms / cost.update_ms});
    }
    return numbers;
}

}  // namespace

Figure figure_13(const Worlds& worlds) {
    std::vector<WorldCost> costs;
    for (const World* world : {&worlds.workplace, &worlds.mit_csail, &worlds.intel}) {
        costs.push_back(cost_of(*world));
    }
    Figure figure;
    figure.number = "13";
    figure.title = "Share of the tree that a scan reaches, and a KD-tree built anew";
    figure.paper =
        "ps is 100 % when the observation crosses the middle of the map; in many cases less than "
        "25 % of the nodes are reconstructed, where a KD-tree reconstructs all.";
    figure.setting =
        "Scans go one by one into the quadtree, the latest wins, as in the paper. ps: nodes of the "
        "smallest block of the tree that covers what a scan speaks of, over all nodes (eq. 12); "
        "nodes rebuilt: those that were not there before, or had another state; nodes touched: "
        "those in and above the tiles that the scan changed. The KD-tree holds the map's obstacle "
        "cells and is built anew. An observation crosses the middle when it lies on both sides of "
        "a line that halves the root.";
    figure.pictures = pictures_of(costs);
    figure.tables = {table_of(costs)};
    figure.claims = judge(numbers_of(costs));
    return figure;
}

}  // namespace quadcut::reproduce
