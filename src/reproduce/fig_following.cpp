// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Figs 13 and 14: what following saves.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "reproduce/experiments.hpp"
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
            const std::vector<Cell> points = obstacles_of(map);
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

std::vector<double> heights(const std::vector<Point>& points) {
    std::vector<double> values;
    for (const Point& point : points) values.push_back(point.y);
    return values;
}

double highest(const std::vector<Point>& points) {
    double value = 0.0;
    for (const Point& point : points) value = std::max(value, point.y);
    return value;
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

/// Fig 13 on one world.
struct WorldCost {
    std::string name;
    Updates updates;
    double percent_below = 0.0;
    double percent_below_near = 0.0;
    double median_touched = 0.0;
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
                 {"nodes touched, median", "%", {none()}},
                 {"KD-tree: nodes reconstructed", "%", {words("100")}},
                 {"quadtree, one scan, median", "ms", {none()}},
                 {"KD-tree built anew, median", "ms", {none()}}}};
    for (const WorldCost& cost : costs) {
        table.columns.push_back(cost.name);
        const std::vector<Value> values{cost.updates.num_crossing > 0
                                            ? number(cost.updates.ps_when_crossing, 1)
                                            : words("never"),
                                        number(cost.percent_below, 1),
                                        number(cost.percent_below_near, 1),
                                        number(cost.median_touched, 2),
                                        number(100.0),
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
                         {"nodes touched", cost.updates.touched, CurveStyle::dots},
                         {"KD-tree: all", {{0.0, 100.0}, {end, 100.0}}}},
                        100.0};
        pictures.push_back({"fig13_" + std::to_string(pictures.size() + 1) + ".svg", to_svg(plot),
                            cost.name + ": each dot is a scan"});
    }
    const WorldCost& last = costs.back();
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

/// "1.2 on workplace, 5.9 on Intel".
template <typename Part, typename NumberOf>
std::string by_world(const std::vector<Part>& parts, const char* unit, const NumberOf& number_of) {
    std::string text;
    for (const Part& part : parts) {
        text += (text.empty() ? "" : ", ") + in_words(number_of(part)) + unit + " on " + part.name;
    }
    return text;
}

template <typename Part, typename Holds>
bool all(const std::vector<Part>& parts, const Holds& holds) {
    return std::all_of(parts.begin(), parts.end(), holds);
}

std::vector<Claim> claims_of(const std::vector<WorldCost>& costs) {
    return {
        {all(costs,
             [](const WorldCost& c) {
                 return c.updates.num_crossing == 0 || c.updates.ps_when_crossing > 99.9;
             }),
         "when the middle is crossed, ps is " +
             by_world(costs, " %", [](const WorldCost& c) { return c.updates.ps_when_crossing; })},
        {all(costs, [](const WorldCost& c) { return c.percent_below >= 50.0; }),
         "scans with a ps of at most 25 %: " +
             by_world(costs, " %", [](const WorldCost& c) { return c.percent_below; }) +
             "; with a laser of 4 m " +
             by_world(costs, " %", [](const WorldCost& c) { return c.percent_below_near; })},
        {all(costs, [](const WorldCost& c) { return c.median_touched < 25.0; }),
         "nodes really touched, median: " +
             by_world(costs, " %", [](const WorldCost& c) { return c.median_touched; })},
        {all(costs, [](const WorldCost& c) { return c.update_ms < c.tree_ms; }),
         "times that a scan goes into the quadtree while a KD-tree is built anew: " +
             by_world(costs, "", [](const WorldCost& c) { return c.tree_ms / c.update_ms; })}};
}

/// Fig 14 on one world: preset `paper`.
struct Growth {
    std::string name;
    /// From the second to the last quarter of the scans.
    double whole = 1.0;
    double local = 1.0;
    /// Mean nodes of a cut over those of the whole map at the end.
    double share = 0.0;
};

double growth_of(const std::vector<Point>& points) {
    const double sooner = mean_between(points, 0.25, 0.5);
    return sooner > 0.0 ? mean_between(points, 0.75, 1.0) / sooner : 1.0;
}

Growth growth_of(const World& world, const Followed& followed) {
    return {world.name, growth_of(followed.whole_nodes), growth_of(followed.local_nodes),
            mean(followed.local_nodes) / std::max(1.0, followed.whole_nodes.back().y)};
}

Picture nodes_picture(const World& world, const Followed& followed, const std::string& file) {
    const Plot plot{
        world.name + ": nodes of the graph, preset paper",
        "scan",
        "nodes",
        {{"basic", followed.whole_nodes}, {"incremental", followed.local_nodes, CurveStyle::dots}}};
    return {file, to_svg(plot), "Preset paper: whole map, and what an update cuts"};
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
        "nodes touched: those in and above the tiles that the scan changed. The KD-tree holds the "
        "map's obstacle cells and is built anew. Many is taken for most of the scans.";
    figure.pictures = pictures_of(costs);
    figure.tables = {table_of(costs)};
    figure.claims = claims_of(costs);
    return figure;
}

Figure figure_14(const Worlds& worlds, const FollowedTwice& workplace, const FollowedTwice& intel) {
    constexpr double kStable = 1.25;
    Figure figure;
    figure.number = "14";
    figure.title = "Size of the matrix over time, basic and incremental";
    figure.paper =
        "The basic algorithm's matrix grows with the map, the incremental one's remains "
        "stable. The values stand in a chart only.";
    figure.setting =
        "Free leaves of the whole map, which the basic algorithm cuts anew, against the nodes of "
        "the graph that an update cuts, in the preset paper (workplace on cells of 10 cm, " +
        worlds.intel.name +
        " of 20 cm); in the preset rooms nodes are basins of the clearance. Growth: the mean of "
        "the last quarter of the scans over that of the second; stable is a factor below 1.25.";
    const std::vector<Growth> growths{growth_of(worlds.workplace, workplace.paper),
                                      growth_of(worlds.intel, intel.paper)};
    Table table{
        "", {"preset paper, basic", "preset paper, incremental", "preset rooms, incremental"}, {}};
    for (const auto& [world, twice] :
         {std::pair(&worlds.workplace, &workplace), std::pair(&worlds.intel, &intel)}) {
        table.rows.push_back(
            {world->name + ": nodes (basic: at the end; else the mean of a cut)",
             "",
             {number(twice->paper.whole_nodes.back().y), number(mean(twice->paper.local_nodes)),
              number(mean(twice->rooms.local_nodes))}});
        table.rows.push_back({world->name + ": growth",
                              "",
                              {number(growth_of(twice->paper.whole_nodes), 2),
                               number(growth_of(twice->paper.local_nodes), 2),
                               number(growth_of(twice->rooms.local_nodes), 2)}});
    }
    figure.tables = {table};
    const Plot plot{worlds.intel.name + ": nodes of the graph, preset rooms",
                    "scan",
                    "basins",
                    {{"incremental", intel.rooms.local_nodes, CurveStyle::dots}}};
    figure.pictures = {nodes_picture(worlds.workplace, workplace.paper, "fig14_1.svg"),
                       nodes_picture(worlds.intel, intel.paper, "fig14_2.svg"),
                       {"fig14_rooms.svg", to_svg(plot), "Preset rooms: what an update cuts"}};
    figure.claims = {
        {all(growths, [](const Growth& g) { return g.whole > 1.0; }),
         "the whole map's matrix grows by a factor of " +
             by_world(growths, "", [](const Growth& g) { return g.whole; })},
        {all(growths, [](const Growth& g) { return g.local < kStable; }),
         "that of an update changes by a factor of " +
             by_world(growths, "", [](const Growth& g) { return g.local; })},
        {all(growths, [](const Growth& g) { return g.share < 0.5; }),
         "its mean share of the whole map's nodes is " +
             by_world(growths, " %", [](const Growth& g) { return 100.0 * g.share; })}};
    return figure;
}

}  // namespace quadcut::reproduce
