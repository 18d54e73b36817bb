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

Figure figure_13(const Worlds& worlds, const Setup& setup) {
    Figure figure;
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
    Table table{"", {}, {}};
    table.columns = {"the paper"};
    std::vector<std::vector<Value>> values(7);
    values[0] = {words("100")};
    values[1] = {words("many")};
    for (std::size_t i = 2; i < values.size(); ++i) values[i] = {none()};
    values[6] = {words("100")};
    double below_quarter = 0.0;
    double below_quarter_short = 0.0;
    double crossing = 100.0;
    double touched = 0.0;
    double speed = 1e9;
    const IntegrateOptions options = latest_scan_wins();
    IntegrateOptions short_range = options;
    short_range.usable_range_m = kShortRangeM;
    for (const World* world : {&worlds.workplace, &worlds.mit_csail, &worlds.intel}) {
        const Updates updates = lay_in(*world, options, true);
        const Updates near = lay_in(*world, short_range, false);
        const double update_ms = mean(updates.update_ms);
        const double tree_ms = mean(updates.kd_tree_ms);
        table.columns.push_back(world->name);
        values[0].push_back(updates.num_crossing > 0 ? number(updates.ps_when_crossing, 1)
                                                     : words("never"));
        values[1].push_back(number(percent_below_quarter(updates), 1));
        values[2].push_back(number(percent_below_quarter(near), 1));
        values[3].push_back(number(median(heights(updates.touched)), 2));
        values[4].push_back(number(update_ms, 3));
        values[5].push_back(number(tree_ms, 3));
        values[6].push_back(number(100.0, 0));
        below_quarter = std::max(below_quarter, percent_below_quarter(updates));
        below_quarter_short = std::max(below_quarter_short, percent_below_quarter(near));
        if (updates.num_crossing > 0) crossing = std::min(crossing, updates.ps_when_crossing);
        touched = std::max(touched, median(heights(updates.touched)));
        speed = std::min(speed, tree_ms / update_ms);
        if (world == &worlds.intel || setup.size == Size::small) continue;
        const Plot plot{world->name + ": ps over time",
                        "scan",
                        "%",
                        {{"ps", updates.ps, CurveStyle::dots},
                         {"nodes touched", updates.touched, CurveStyle::dots},
                         {"KD-tree: all", {{0.0, 100.0}, {updates.ps.back().x, 100.0}}}},
                        100.0};
        figure.pictures.push_back({"fig13_" + std::to_string(figure.pictures.size() + 1) + ".svg",
                                   to_svg(plot), "Each dot is a scan"});
    }
    // The last world's times; smoothed curves would hide what a single scan costs.
    const Updates updates = lay_in(worlds.intel, options, true);
    const Plot ps{worlds.intel.name + ": ps over time",
                  "scan",
                  "%",
                  {{"ps", updates.ps, CurveStyle::dots},
                   {"nodes touched", updates.touched, CurveStyle::dots},
                   {"KD-tree: all", {{0.0, 100.0}, {updates.ps.back().x, 100.0}}}},
                  100.0};
    const Plot times{worlds.intel.name + ": time of an update",
                     "scan",
                     "ms",
                     {{"quadtree, one scan", updates.update_ms, CurveStyle::dots},
                      {"KD-tree built anew", updates.kd_tree_ms}}};
    figure.pictures.push_back({"fig13_intel.svg", to_svg(ps), "Each dot is a scan"});
    figure.pictures.push_back({"fig13_times.svg", to_svg(times), "Wall time"});
    const std::vector<std::pair<const char*, const char*>> names{
        {"ps when the middle is crossed", "%"},  {"scans with ps of at most 25 %", "%"},
        {"the same, laser limited to 4 m", "%"}, {"nodes touched, median", "%"},
        {"quadtree, one scan, mean", "ms"},      {"KD-tree built anew, mean", "ms"},
        {"KD-tree: nodes reconstructed", "%"}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.rows.push_back({names[i].first, names[i].second, values[i]});
    }
    figure.tables = {table};
    figure.claims = {
        {crossing > 99.9, "ps is " + in_words(crossing) + " % when the middle is crossed"},
        {below_quarter >= 50.0, "at best " + in_words(below_quarter) +
                                    " % of a world's scans have a ps of at most 25 %, " +
                                    in_words(below_quarter_short) +
                                    " % with a laser of 4 m: what a scan covers decides"},
        {touched < 25.0,
         "the nodes really touched are at most " + in_words(touched) + " % in the median"},
        {speed > 1.0, "a scan into the quadtree is at least " + in_words(speed) +
                          " times as fast as a KD-tree built anew"}};
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
    double share = 0.0;
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
            table.rows[0].values.push_back(number(followed->whole_nodes.back().y));
            table.rows[1].values.push_back(number(mean(followed->local_nodes), 0));
            table.rows[2].values.push_back(sooner > 0.0 ? number(later / sooner, 2) : none());
            table.rows[3].values.push_back(number(basic, 2));
            if (followed != &twice->paper) continue;
            if (sooner > 0.0) growth = std::max(growth, later / sooner);
            basic_growth = std::min(basic_growth, basic);
            share = std::max(share, mean(followed->local_nodes) / followed->whole_nodes.back().y);
        }
    }
    const Plot plot{worlds.intel.name + ": nodes of the graph, preset rooms",
                    "scan",
                    "basins",
                    {{"incremental", intel.rooms.local_nodes, CurveStyle::dots}}};
    figure.pictures.push_back(
        {"fig14_rooms.svg", to_svg(plot), "Preset rooms: what an update cuts"});
    figure.tables = {table};
    figure.claims = {{basic_growth > 1.0,
                      "from the second to the last quarter of the scans the whole map's "
                      "matrix grows by a factor of at least " +
                          in_words(basic_growth)},
                     {growth < 1.5 && growth < basic_growth * 1.1,
                      "that of an update changes by a factor of at most " + in_words(growth)},
                     {share < 0.5, "in the mean it has at most " + in_words(100.0 * share) +
                                       " % of the whole map's nodes"}};
    return figure;
}

}  // namespace quadcut::reproduce
