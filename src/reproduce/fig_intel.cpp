// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Fig 18: the Intel lab, the whole map and a local segmentation.
#include <algorithm>
#include <string>
#include <vector>

#include "quadcut/map/integrate.hpp"
#include "quadcut/paper/submaps.hpp"
#include "reproduce/contest.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/map_graph.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/sentence.hpp"
#include "reproduce/timing.hpp"

namespace quadcut::reproduce {
namespace {

/// The cells on which so many nodes are a few rooms.
constexpr double kLocalCellM = 0.2;
constexpr std::size_t kLocalNodes = 150;
constexpr std::size_t kNumPlaces = 40;

/// Local segmentations around places on the robot's way.
struct LocalCuts {
    double median_ms = 0.0;
    double mean_nodes = 0.0;
};

/// So many nodes around one of them, by the fewest edges; ascending.
std::vector<std::uint32_t> nodes_around(const Graph& graph, std::uint32_t from) {
    std::vector<bool> is_met(graph.num_nodes(), false);
    std::vector<std::uint32_t> nodes{from};
    is_met[from] = true;
    for (std::size_t i = 0; i < nodes.size() && nodes.size() < kLocalNodes; ++i) {
        for (const std::uint32_t other : graph.neighbours(nodes[i])) {
            if (is_met[other] || nodes.size() >= kLocalNodes) continue;
            is_met[other] = true;
            nodes.push_back(other);
        }
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

LocalCuts cut_around(const World& world, const Setup& setup) {
    const GridMap map = map_from_scans(world.scans, kLocalCellM).to_grid();
    const MapGraph whole = graph_of(map, SelfLoops::none, setup.executor());
    const Pose image_from_map = inverse(map.map_from_image);
    std::vector<double> times_ms;
    double num_nodes = 0.0;
    const std::size_t step = std::max<std::size_t>(1, world.trajectory.size() / kNumPlaces);
    for (std::size_t i = 0; i < world.trajectory.size(); i += step) {
        const Point at = transform(image_from_map, world.trajectory[i]);
        const std::optional<LeafId> leaf =
            whole.leaves.table.find({static_cast<std::int32_t>(at.x / map.resolution_m),
                                     static_cast<std::int32_t>(at.y / map.resolution_m)});
        if (!leaf) continue;
        const std::vector<LeafId>& all = whole.leaves.nodes;
        const auto found = std::lower_bound(all.begin(), all.end(), *leaf);
        if (found == all.end() || *found != *leaf) continue;
        std::vector<LeafId> nodes;
        for (const std::uint32_t node :
             nodes_around(whole.graph, static_cast<std::uint32_t>(found - all.begin()))) {
            nodes.push_back(all[node]);
        }
        // The graph of the region, its cut, division and fusion: all of a local segmentation.
        times_ms.push_back(elapsed_ms([&] {
            const Graph local =
                build_graph(sight_edges(whole.leaves.table, nodes, map.resolution_m,
                                        SelfLoops::own_weight, setup.executor()),
                            leaf_areas_m2(whole.leaves.table, nodes, map.resolution_m));
            StageClock clock;
            static_cast<void>(
                find_submaps(local, setup.paper(0).paper, setup.seed, clock, setup.executor()));
        }));
        num_nodes += static_cast<double>(nodes.size());
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, times_ms.size()));
    return {median(times_ms), num_nodes / count};
}

/// The lines of the summary.
std::vector<Headline> headlines_of(const World& world, const Contest& contest,
                                   const LocalCuts& local, const FollowedTwice& intel) {
    return {
        {"Whole map of " + world.name + ", preset paper", kPaperWholeMs, contest.paper.elapsed_ms,
         "cells of 5 cm, " + in_words(static_cast<double>(contest.paper.num_units)) + " nodes"},
        {"Whole map of " + world.name + ", preset rooms", kPaperWholeMs, contest.rooms.elapsed_ms,
         "cells of 5 cm"},
        {"Local segmentation of about 150 nodes, preset paper", kPaperLocalMs, local.median_ms,
         "median of " + std::to_string(kNumPlaces) + " places, " + in_words(local.mean_nodes) +
             " nodes"},
        {"Local update while following, preset paper", kPaperLocalMs,
         median(heights(intel.paper.cut_ms)),
         "median of all cuts, cells of " + in_words(100.0 * world.paper_cell_m) + " cm, " +
             in_words(mean(intel.paper.cut_nodes)) + " nodes in the mean"},
        {"Local update while following, preset rooms", kPaperLocalMs,
         median(heights(intel.rooms.cut_ms)),
         "median of all cuts, cells of 5 cm, all within 20 m of what has changed"}};
}

}  // namespace

IntelResult figure_18(const Worlds& worlds, const FollowedTwice& intel, const Setup& setup) {
    const World& world = worlds.intel;
    const Contest contest = hold_contest(world, 0, setup);
    const LocalCuts local = cut_around(world, setup);
    const double paper_update_ms = median(heights(intel.paper.cut_ms));
    const double rooms_update_ms = median(heights(intel.rooms.cut_ms));
    const std::string nodes = in_words(local.mean_nodes);

    IntelResult result;
    Figure& figure = result.figure;
    figure.number = "18";
    figure.title = world.name + ": the whole map, and a local segmentation";
    figure.paper =
        "More than 17,300 ms for a segmentation of the whole map, 43 ms for a local one of about "
        "150 nodes (Python 2.7, i7-4700MQ). The result shows the correctness of the algorithm; the "
        "borders are rough, and a corridor is cut by the size of the rooms beside it.";
    figure.setting =
        "The whole map on cells of 5 cm, " +
        in_words(static_cast<double>(contest.paper.num_units)) +
        " free leaves: graph, eigenvectors, submaps, their division and fusion. "
        "Local: " +
        nodes + " nodes around " + std::to_string(kNumPlaces) +
        " places on the robot's way on cells of 20 cm, each its graph and all steps after it; and "
        "the cuts of following the scans.";
    figure.pictures = pictures_of(contest, world, "fig18");
    figure.tables = {table_of(contest, number(kPaperWholeMs), none())};
    figure.tables[0].title = "The whole map";
    figure.tables.push_back(
        {"Locally",
         {"the paper", "preset paper", "preset rooms"},
         {{"local segmentation, median",
           "ms",
           {number(kPaperLocalMs), number(local.median_ms, 2), none()}},
          {"its nodes", "", {words("about 150"), number(local.mean_nodes, 0), none()}},
          {"update while following, median",
           "ms",
           {none(), number(paper_update_ms, 1), number(rooms_update_ms, 1)}},
          {"its nodes, mean",
           "",
           {none(), number(mean(intel.paper.cut_nodes), 0),
            number(mean(intel.rooms.cut_nodes), 0)}},
          {"PQ of what following ends with",
           "%",
           {none(), number(pq_percent(intel.paper.rooms(), intel.paper.map(), world), 1),
            number(pq_percent(intel.rooms.rooms(), intel.rooms.map(), world), 1)}}}});
    result.headlines = headlines_of(world, contest, local, intel);
    IntelNumbers numbers;
    numbers.whole_ms = contest.paper.elapsed_ms;
    numbers.local_ms = local.median_ms;
    numbers.pq_percent = {contest.paper.quality.pq_percent.value_or(0.0),
                          contest.positions.quality.pq_percent.value_or(0.0)};
    numbers.followed_pq_percent =
        pq_percent(intel.paper.rooms(), intel.paper.map(), world).value_or(0.0);
    numbers.open_border_percent = {contest.paper.quality.open_border_percent,
                                   contest.rooms.quality.open_border_percent};
    figure.claims = judge(numbers);
    return result;
}

}  // namespace quadcut::reproduce
