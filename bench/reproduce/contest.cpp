// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/reproduce/contest.hpp"

#include <algorithm>
#include <utility>

#include "bench/reproduce/map_picture.hpp"
#include "bench/reproduce/position_clusters.hpp"
#include "bench/reproduce/sentence.hpp"
#include "bench/reproduce/voronoi.hpp"
#include "bench/timing.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut::reproduce {
namespace {

constexpr double kMinPartM2 = 4.0;

Contender segmented(const World& world, const SegmentOptions& options) {
    Contender result;
    // As many submaps as were asked for are all shown, crossed by the robot or not.
    const bool is_told = options.preset == Preset::paper && options.paper.num_submaps != 0;
    const std::vector<Point> trajectory = is_told ? std::vector<Point>{} : world.trajectory;
    result.elapsed_ms = elapsed_ms([&] { result.rooms = segment(world.map, options, trajectory); });
    result.labels = labels_of_cells(result.rooms);
    result.num_units = result.rooms.report.num_leaves;
    return result;
}

Contender by_positions(const World& world, const MapGraph& graph, std::size_t count,
                       std::uint64_t seed) {
    Contender result;
    std::vector<std::uint32_t> clusters;
    result.elapsed_ms = elapsed_ms(
        [&] { clusters = cluster_positions(graph.leaves.table, graph.leaves.nodes, count, seed); });
    result.labels = labels_of_cells(graph, world.map, clusters);
    result.rooms = as_segmentation(result.labels);
    result.num_units = graph.leaves.nodes.size();
    return result;
}

Contender by_voronoi(const World& world) {
    Contender result;
    VoronoiRegions voronoi;
    result.elapsed_ms = elapsed_ms([&] {
        voronoi = voronoi_regions(inside(world.map, world.trajectory, kMinPartM2),
                                  world.map.resolution_m);
    });
    result.labels = std::move(voronoi.regions);
    result.rooms = as_segmentation(result.labels);
    result.num_units = voronoi.num_graph_cells;
    return result;
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
    contest.paper = segmented(world, setup.paper(num_submaps));
    contest.rooms = segmented(world, setup.rooms());
    const std::size_t count =
        num_submaps != 0 ? num_submaps : std::max<std::size_t>(2, contest.paper.rooms.rooms.size());
    contest.positions = by_positions(world, contest.graph, count, setup.seed);
    contest.voronoi = by_voronoi(world);
    for (Contender* contender :
         {&contest.paper, &contest.rooms, &contest.positions, &contest.voronoi}) {
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
    row("coupling: edge weight that leaves a region, mean", "%", words("low"),
        [](const Contender& c) { return number(c.quality.coupling_percent, 2); });
    row("largest region over the mean", "", words("balanced"),
        [](const Contender& c) { return number(c.quality.imbalance, 2); });
    if (contest.paper.quality.pq_percent) {
        row("PQ against the true rooms", "%", none(), [](const Contender& c) {
            return c.quality.pq_percent ? number(*c.quality.pq_percent, 1) : none();
        });
    }
    return table;
}

std::vector<Picture> pictures_of(const Contest& contest, const World& world,
                                 const std::string& name) {
    const auto picture = [&](const char* method, const char* words, const Contender& contender) {
        return plan_picture(name + "_" + method + ".png", world.map, contender.rooms,
                            caption(words, contender));
    };
    return {picture("paper", "Preset paper", contest.paper),
            picture("rooms", "Preset rooms", contest.rooms),
            picture("kmeans", "k-means of positions, no graph", contest.positions),
            picture("voronoi", "Voronoi graph, cut where it is narrowest", contest.voronoi)};
}

}  // namespace quadcut::reproduce
