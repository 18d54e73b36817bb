// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Fig 14: what an update cuts, and what the whole map would be.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/plot.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

/// The mean of a part of the scans, first and last as shares of all.
double mean_between(const std::vector<Point>& points, double first, double last) {
    if (points.empty()) return 0.0;
    const double end = points.back().x;
    std::vector<Point> chosen;
    for (const Point& point : points) {
        if (point.x > first * end && point.x <= last * end) chosen.push_back(point);
    }
    return mean(chosen);
}

/// The last quarter of the scans over the second.
double growth_of(const std::vector<Point>& points) {
    const double sooner = mean_between(points, 0.25, 0.5);
    return sooner > 0.0 ? mean_between(points, 0.75, 1.0) / sooner : 1.0;
}

double percent_of_basic(double update, const std::vector<Point>& basic) {
    return 100.0 * update / basic.back().y;
}

std::vector<Row> rows_of(const Followed& paper, const Followed& rooms) {
    const auto row = [](const char* name, const char* unit, double basic, double update,
                        double rooms_basic, double rooms_update, int decimals) {
        return Row{name,
                   unit,
                   {number(basic, decimals), number(update, decimals),
                    number(rooms_basic, decimals), number(rooms_update, decimals)}};
    };
    return {
        row("nodes (basic: at the end; else the mean of a cut)", "", paper.whole_leaves.back().y,
            mean(paper.cut_nodes), rooms.basic_nodes.back().y, mean(rooms.cut_nodes), 0),
        row("growth of the nodes", "", growth_of(paper.whole_leaves), growth_of(paper.cut_nodes),
            growth_of(rooms.basic_nodes), growth_of(rooms.cut_nodes), 2),
        row("time (basic: at the end; else the median of a cut)", "ms", paper.basic_ms.back().y,
            median(heights(paper.cut_ms)), rooms.basic_ms.back().y, median(heights(rooms.cut_ms)),
            1)};
}

std::vector<Picture> pictures_of(const World& world, const FollowedTwice& twice,
                                 const std::string& name) {
    const Plot leaves{world.name + ", preset paper: nodes of the graph",
                      "scan",
                      "leaves",
                      {{"basic", twice.paper.whole_leaves},
                       {"incremental", twice.paper.cut_nodes, CurveStyle::dots}}};
    const Plot basins{world.name + ", preset rooms: nodes of the graph",
                      "scan",
                      "basins",
                      {{"basic", twice.rooms.basic_nodes},
                       {"incremental", twice.rooms.cut_nodes, CurveStyle::dots}}};
    Plot times{world.name + ": time",
               "scan",
               "ms",
               {{"paper, basic", twice.paper.basic_ms},
                {"paper, an update", twice.paper.cut_ms, CurveStyle::dots},
                {"rooms, basic", twice.rooms.basic_ms},
                {"rooms, an update", twice.rooms.cut_ms, CurveStyle::dots}}};
    times.is_y_log = true;
    const std::string cells = "cells of " + in_words(100.0 * world.paper_cell_m) + " cm";
    return {{name + "_paper.svg", to_svg(leaves), "Preset paper, " + cells},
            {name + "_rooms.svg", to_svg(basins), "Preset rooms, cells of 5 cm"},
            {name + "_times.svg", to_svg(times),
             "Wall time; the basic algorithm cuts the whole map anew", Span::full}};
}

}  // namespace

Figure figure_14(const Worlds& worlds, const FollowedWorlds& followed) {
    Figure figure;
    figure.number = "14";
    figure.title = "Size of the matrix and time of a cut, basic and incremental";
    figure.paper =
        "The basic algorithm's matrix grows with the map, the incremental one's remains "
        "stable. The values stand in a chart only.";
    figure.setting =
        "Basic: the free leaves of the whole map, and at six moments the time of cutting it anew. "
        "Incremental: the nodes and the time of each update. In the preset rooms nodes are basins "
        "of the clearance. Growth: the mean of the last quarter of the scans over that of the "
        "second.";
    GrowthNumbers numbers;
    const std::vector<std::pair<const World*, const FollowedTwice*>> all{
        {&worlds.workplace, &followed.workplace},
        {&worlds.mit_csail, &followed.mit_csail},
        {&worlds.intel, &followed.intel}};
    for (const auto& [world, twice] : all) {
        const Followed& paper = twice->paper;
        for (Picture& picture :
             pictures_of(*world, *twice, "fig14_" + std::to_string(figure.tables.size() + 1))) {
            figure.pictures.push_back(std::move(picture));
        }
        figure.tables.push_back({world->name,
                                 {"preset paper, basic", "preset paper, incremental",
                                  "preset rooms, basic", "preset rooms, incremental"},
                                 rows_of(paper, twice->rooms)});
        numbers.basic_growth.push_back({world->name, growth_of(paper.whole_leaves)});
        numbers.update_growth.push_back({world->name, growth_of(paper.cut_nodes)});
        numbers.node_percent.push_back(
            {world->name, percent_of_basic(mean(paper.cut_nodes), paper.whole_leaves)});
        numbers.time_percent.push_back(
            {world->name, percent_of_basic(median(heights(paper.cut_ms)), paper.basic_ms)});
    }
    figure.claims = judge(numbers);
    return figure;
}

}  // namespace quadcut::reproduce
