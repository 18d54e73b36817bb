// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Figs 13 and 14: what following saves.
#include <algorithm>
#include <string>
#include <vector>

#include "bench/kd_tree.hpp"
#include "bench/reproduce/experiments.hpp"
#include "bench/reproduce/plot.hpp"
#include "bench/reproduce/sentence.hpp"
#include "bench/timing.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"

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
    std::vector<Point> update_ms;
    std::vector<Point> kd_tree_ms;
    /// Scans of which the observation crosses the middle of the map, so that the tree's root is
    /// the smallest block that covers it.
    std::size_t num_crossing = 0;
    double ps_when_crossing = 0.0;
};

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
        result.update_ms.push_back({at, ms});
        if (*update.covering == map.root()) {
            ++result.num_crossing;
            result.ps_when_crossing += 100.0 * ps;
        }
        if (with_trees && (i + 1) % sample == 0) {
            std::vector<Cell> points = obstacles_of(map);
            result.kd_tree_ms.push_back(
                {at, elapsed_ms([&] { const KdTree tree(std::move(points)); })});
        }
    }
    if (result.num_crossing > 0) {
        result.ps_when_crossing /= static_cast<double>(result.num_crossing);
    }
    return result;
}

std::vector<double> heights(const std::vector<Point>& points) {
    std::vector<double> values;
    for (const Point& point : points) values.push_back(point.y);
    return values;
}

double mean(const std::vector<Point>& points) {
    double sum = 0.0;
    for (const Point& point : points) sum += point.y;
    return points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

/// Percent of the scans with a ps of at most a quarter.
double percent_below_quarter(const Updates& updates) {
    const auto below = std::count_if(updates.ps.begin(), updates.ps.end(), [](const Point& point) {
        return point.y <= 100.0 * kQuarter;
    });
    return 100.0 * static_cast<double>(below) /
           static_cast<double>(std::max<std::size_t>(1, updates.ps.size()));
}

/// The values of a part of the scans, first and last as shares of all.
double mean_between(const std::vector<Point>& points, double first, double last) {
    if (points.empty()) return 0.0;
    const double end = points.back().x;
    std::vector<Point> chosen;
    for (const Point& point : points) {
        if (point.x > first * end && point.x <= last * end) chosen.push_back(point);
    }
    return mean(chosen);
}

}  // namespace

Figure figure_13(const Worlds& worlds) {
    IntegrateOptions short_range = latest_scan_wins();
    short_range.usable_range_m = kShortRangeM;
    Table table{"",
                {"the paper"},
                {{"ps when the middle is crossed", "%", {words("100")}},
                 {"scans with ps of at most 25 %", "%", {words("many")}},
                 {"the same, laser limited to 4 m", "%", {none()}},
                 {"nodes touched, median", "%", {none()}},
                 {"KD-tree: nodes reconstructed", "%", {words("100")}},
                 {"quadtree, one scan, mean", "ms", {none()}},
                 {"KD-tree built anew, mean", "ms", {none()}}}};
    Figure figure;
    Picture times;
    double crossing = 100.0;
    double touched = 0.0;
    double slowest = 1e9;
    std::string shares;
    std::string near_shares;
    std::string speeds;
    bool is_mostly_below = true;
    for (const World* world : {&worlds.workplace, &worlds.mit_csail, &worlds.intel}) {
        const Updates updates = lay_in(*world, latest_scan_wins(), true);
        const double below = percent_below_quarter(updates);
        const double near = percent_below_quarter(lay_in(*world, short_range, false));
        const double update_ms = mean(updates.update_ms);
        const double tree_ms = mean(updates.kd_tree_ms);
        const double median_touched = median(heights(updates.touched));
        const bool is_crossed = updates.num_crossing > 0;
        table.columns.push_back(world->name);
        const std::vector<Value> values{
            is_crossed ? number(updates.ps_when_crossing, 1) : words("never"),
            number(below, 1),
            number(near, 1),
            number(median_touched, 2),
            number(100.0),
            number(update_ms, 3),
            number(tree_ms, 3)};
        for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].values.push_back(values[i]);
        if (is_crossed) crossing = std::min(crossing, updates.ps_when_crossing);
        is_mostly_below = is_mostly_below && below >= 50.0;
        touched = std::max(touched, median_touched);
        slowest = std::min(slowest, tree_ms / update_ms);
        const std::string comma = shares.empty() ? "" : ", ";
        shares += comma + in_words(below) + " % on " + world->name;
        near_shares += comma + in_words(near) + " %";
        speeds += comma + in_words(tree_ms / update_ms) + " on " + world->name;
        const Plot ps{world->name + ": ps over time",
                      "scan",
                      "%",
                      {{"ps", updates.ps, CurveStyle::dots},
                       {"nodes touched", updates.touched, CurveStyle::dots},
                       {"KD-tree: all", {{0.0, 100.0}, {updates.ps.back().x, 100.0}}}},
                      100.0};
        figure.pictures.push_back({"fig13_" + std::to_string(figure.pictures.size() + 1) + ".svg",
                                   to_svg(ps), "Each dot is a scan"});
        const Plot plot{world->name + ": time of an update",
                        "scan",
                        "ms",
                        {{"quadtree, one scan", updates.update_ms, CurveStyle::dots},
                         {"KD-tree built anew", updates.kd_tree_ms}}};
        times = {"fig13_times.svg", to_svg(plot), "Wall time"};
    }
    figure.pictures.push_back(std::move(times));
    figure.number = "13";
    figure.title = "Share of the tree that a scan reaches, and a KD-tree built anew";
    figure.paper =
        "ps is 100 % when the observation crosses the middle of the map; in many cases less than "
        "25 % of the nodes are reconstructed, where a KD-tree reconstructs all.";
    figure.setting =
        "Scans go one by one into the quadtree, the latest wins, as in the paper. ps: nodes of the "
        "smallest block of the tree that covers what a scan speaks of, over all nodes (eq. 12); "
        "nodes touched: those in and above the tiles that the scan changed. The KD-tree holds the "
        "map's obstacle cells and is built anew.";
    figure.tables = {table};
    figure.claims = {
        {crossing > 99.9, "ps is " + in_words(crossing) + " % when the middle is crossed"},
        {is_mostly_below, "ps is at most 25 % in " + shares + " (with a laser of 4 m in " +
                              near_shares + "), not in most of the scans everywhere"},
        {touched < 25.0,
         "the nodes really touched are at most " + in_words(touched) + " % in the median"},
        {slowest > 1.0, "times as fast as a KD-tree built anew: " + speeds}};
    if (is_mostly_below) {
        figure.claims[1].text = "ps is at most 25 % in most of the scans: " + shares;
    }
    return figure;
}

Figure figure_14(const Worlds& worlds, const FollowedTwice& workplace, const FollowedTwice& intel) {
    Figure figure;
    figure.number = "14";
    figure.title = "Size of the matrix over time, basic and incremental";
    figure.paper =
        "The basic algorithm's matrix grows with the map, the incremental one's remains "
        "stable. The values stand in a chart only.";
    figure.setting =
        "Free leaves of the whole map, which the basic algorithm cuts anew, against the nodes of "
        "the graph that an update cuts, in the preset paper (workplace on cells of 10 cm, " +
        worlds.intel.name + " of 20 cm); in the preset rooms nodes are basins of the clearance.";
    Table table{"",
                {worlds.workplace.name + ", paper", worlds.workplace.name + ", rooms",
                 worlds.intel.name + ", paper", worlds.intel.name + ", rooms"},
                {{"basic: nodes at the end", "", {}},
                 {"incremental: mean nodes of a cut", "", {}},
                 {"incremental: last quarter over the second", "", {}},
                 {"basic: last quarter over the second", "", {}}}};
    double growth = 0.0;
    double basic_growth = 1e9;
    double largest_share = 0.0;
    std::string shares;
    std::size_t index = 0;
    for (const auto& [world, twice] :
         {std::pair(&worlds.workplace, &workplace), std::pair(&worlds.intel, &intel)}) {
        const Plot plot{world->name + ": nodes of the graph, preset paper",
                        "scan",
                        "nodes",
                        {{"basic", twice->paper.whole_nodes},
                         {"incremental", twice->paper.local_nodes, CurveStyle::dots}}};
        figure.pictures.push_back({"fig14_" + std::to_string(++index) + ".svg", to_svg(plot),
                                   "Preset paper: whole map, and what an update cuts"});
        for (const Followed* followed : {&twice->paper, &twice->rooms}) {
            const double later = mean_between(followed->local_nodes, 0.75, 1.0);
            const double sooner = mean_between(followed->local_nodes, 0.25, 0.5);
            const double basic = mean_between(followed->whole_nodes, 0.75, 1.0) /
                                 mean_between(followed->whole_nodes, 0.25, 0.5);
            const bool is_paper = followed == &twice->paper;
            table.rows[0].values.push_back(is_paper ? number(followed->whole_nodes.back().y)
                                                    : none());
            table.rows[1].values.push_back(number(mean(followed->local_nodes), 0));
            table.rows[2].values.push_back(sooner > 0.0 ? number(later / sooner, 2) : none());
            table.rows[3].values.push_back(is_paper ? number(basic, 2) : none());
            if (!is_paper) continue;
            if (sooner > 0.0) growth = std::max(growth, later / sooner);
            basic_growth = std::min(basic_growth, basic);
            const double share = mean(followed->local_nodes) / followed->whole_nodes.back().y;
            largest_share = std::max(largest_share, share);
            shares += (shares.empty() ? "" : " and ") + in_words(100.0 * share) + " % (" +
                      world->name + ")";
        }
    }
    const Plot plot{worlds.intel.name + ": nodes of the graph, preset rooms",
                    "scan",
                    "basins",
                    {{"incremental", intel.rooms.local_nodes, CurveStyle::dots}}};
    figure.pictures.push_back(
        {"fig14_rooms.svg", to_svg(plot), "Preset rooms: what an update cuts"});
    figure.tables = {table};
    figure.claims = {
        {basic_growth > 1.0,
         "from the second to the last quarter of the scans the whole map's "
         "matrix grows by a factor of at least " +
             in_words(basic_growth)},
        {growth < 1.5 && growth < basic_growth * 1.1,
         "that of an update changes by a factor of at most " + in_words(growth)},
        {largest_share < 0.5, "in the mean it has " + shares + " of the whole map's nodes"}};
    return figure;
}

}  // namespace quadcut::reproduce
