// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/contest.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/position_clusters.hpp"
#include "reproduce/sentence.hpp"
#include "reproduce/timing.hpp"
#include "reproduce/voronoi.hpp"

namespace quadcut::reproduce {
namespace {

constexpr double kMinPartM2 = 4.0;

/// What the preset makes of the map.
Segmentation segmented(const World& world, const SegmentOptions& options, const RunOptions& run) {
    // As many submaps as were asked for are all shown, crossed by the robot or not.
    const bool is_told = options.preset == Preset::paper && options.paper.num_submaps != 0;
    return segment(world.map, options, run, is_told ? std::vector<Point>{} : world.trajectory);
}

std::string caption(const std::string& method, const Contender& contender) {
    const Quality& quality = contender.quality;
    std::string text = method + ": " + std::to_string(quality.num_regions) + " regions";
    if (quality.num_broken > 0) {
        text += ", " + std::to_string(quality.num_broken) + " of them on both sides of a wall";
    }
    if (quality.pq_percent) text += ", PQ " + in_words(*quality.pq_percent) + " %";
    return text;
}

}  // namespace

Contest hold_contest(const World& world, std::size_t num_submaps, const Setup& setup) {
    Contest contest{graph_of(world.map, SelfLoops::none, setup.executor()), {}, {}, {}, {}};
    const FreeLeaves& leaves = contest.graph.leaves;
    VoronoiRegions voronoi;
    std::vector<std::uint32_t> clusters;
    const std::vector<double> times_ms = least_ms(
        setup.size == Size::full ? 3 : 1,
        {[&] { contest.paper.rooms = segmented(world, setup.paper(num_submaps), setup.run); },
         [&] { contest.rooms.rooms = segmented(world, setup.rooms(), setup.run); },
         [&] {
             const std::size_t count = contest.paper.rooms.rooms.size();
             clusters = cluster_positions(leaves.table, leaves.nodes,
                                          num_submaps != 0 ? num_submaps : count, setup.seed);
         },
         [&] {
             voronoi = voronoi_regions(inside(world.map, world.trajectory, kMinPartM2),
                                       world.map.resolution_m);
         }});
    contest.paper.rooms = as_submaps(std::move(contest.paper.rooms));
    contest.paper.labels = labels_of_cells(contest.paper.rooms);
    contest.paper.num_units = contest.paper.rooms.report.num_leaves;
    contest.rooms.labels = labels_of_cells(contest.rooms.rooms);
    contest.rooms.num_units = contest.rooms.rooms.report.num_leaves;
    contest.positions.labels = labels_of_cells(contest.graph, world.map, clusters);
    contest.positions.rooms = as_segmentation(contest.positions.labels, world.map);
    contest.positions.num_units = leaves.nodes.size();
    contest.voronoi.labels = std::move(voronoi.regions);
    contest.voronoi.rooms = as_segmentation(contest.voronoi.labels, world.map);
    contest.voronoi.num_units = voronoi.num_graph_cells;
    std::size_t place = 0;
    for (Contender* contender :
         {&contest.paper, &contest.rooms, &contest.positions, &contest.voronoi}) {
        contender->elapsed_ms = times_ms[place++];
        contender->quality = quality_of(contest.graph, contender->labels, world.map, world);
    }
    return contest;
}

Table table_of(const Contest& contest, const Value& paper_ms, const Value& paper_regions) {
    Table table{
        "", {"the paper", "preset paper", "preset rooms", "k-means, no graph", "Voronoi"}, {}};
    const auto row = [&](const char* name, const char* unit, const Value& paper,
                         const auto& value_of) {
        table.rows.push_back({name,
                              unit,
                              {paper, value_of(contest.paper), value_of(contest.rooms),
                               value_of(contest.positions), value_of(contest.voronoi)}});
    };
    row("time", "ms", paper_ms, [](const Contender& c) { return number(c.elapsed_ms, 1); });
    row("regions", "", paper_regions,
        [](const Contender& c) { return number(c.quality.num_regions); });
    row("made of (leaves, basins, graph cells)", "", none(),
        [](const Contender& c) { return number(c.num_units); });
    row("regions on both sides of a wall", "", none(),
        [](const Contender& c) { return number(c.quality.num_broken); });
    row("edge weight that leaves a region, mean", "%", words("low"),
        [](const Contender& c) { return number(c.quality.coupling_percent, 2); });
    row("edge weight between regions, of all", "%", words("low"),
        [](const Contender& c) { return number(c.quality.cut_percent, 2); });
    row("largest region over the mean", "", words("balanced"),
        [](const Contender& c) { return number(c.quality.imbalance, 2); });
    row("border across open floor", "%", none(),
        [](const Contender& c) { return number(c.quality.open_border_percent, 1); });
    if (contest.paper.quality.pq_percent) {
        row("PQ against the true rooms", "%", none(),
            [](const Contender& c) { return number(c.quality.pq_percent, 1); });
    }
    return table;
}

std::vector<Picture> pictures_of(const Contest& contest, const World& world,
                                 const std::string& name) {
    const auto picture = [&](const char* method, const char* words, const Contender& contender) {
        return plan_picture(name + "_" + method + ".png", world.map, contender.rooms,
                            caption(words, contender));
    };
    std::vector<Picture> pictures{
        picture("paper", "Preset paper", contest.paper),
        picture("rooms", "Preset rooms", contest.rooms),
        picture("kmeans", "k-means of positions, no graph", contest.positions),
        picture("voronoi", "Voronoi graph, cut where it is narrowest", contest.voronoi)};
    pictures.front().span = Span::full;
    return pictures;
}

}  // namespace quadcut::reproduce
