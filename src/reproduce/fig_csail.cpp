// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Figs 15 to 17: MIT-CSAIL with ten submaps.
#include <string>
#include <utility>
#include <vector>

#include "reproduce/contest.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

constexpr std::size_t kNumSubmaps = 10;

/// The paper's red lines: between the middles of submaps that an edge joins.
std::vector<std::pair<Point, Point>> links_of(const Contest& contest) {
    const std::vector<Point> middles = middles_of(contest.paper.rooms);
    std::vector<std::pair<Point, Point>> links;
    for (const auto& [a, b] :
         linked_regions(contest.graph, labels_of_nodes(contest.graph, contest.paper.labels))) {
        links.emplace_back(middles[a - 1], middles[b - 1]);
    }
    return links;
}

SubmapNumbers numbers_of(const Contest& contest, std::size_t num_told) {
    const Quality& paper = contest.paper.quality;
    const Quality& positions = contest.positions.quality;
    const auto count = [](std::size_t number) { return static_cast<double>(number); };
    SubmapNumbers numbers;
    numbers.num_told = num_told;
    numbers.num_made = count(paper.num_regions);
    numbers.coupling_percent = {paper.coupling_percent, positions.coupling_percent};
    numbers.cut_percent = {paper.cut_percent, positions.cut_percent};
    numbers.num_broken = {count(paper.num_broken), count(positions.num_broken)};
    numbers.elapsed_ms = {contest.paper.elapsed_ms, contest.positions.elapsed_ms};
    numbers.imbalance = {paper.imbalance, contest.voronoi.quality.imbalance};
    numbers.num_units = {count(contest.paper.num_units), count(contest.voronoi.num_units)};
    return numbers;
}

}  // namespace

Figure figures_15_to_17(const Worlds& worlds, const Setup& setup) {
    const World& world = worlds.mit_csail;
    const std::size_t count = setup.size == Size::small ? 4 : kNumSubmaps;
    const Contest contest = hold_contest(world, count, setup);
    const std::vector<std::pair<Point, Point>> links = links_of(contest);

    Figure figure;
    figure.number = "15-17";
    figure.title = world.name + ": quadtree, graph, and " + std::to_string(count) + " submaps";
    figure.paper =
        "With k = 10 the submaps have high cohesion and low coupling and balanced sizes; red lines "
        "join submaps with an edge between them. k-means without a graph may be faster, but can "
        "hardly follow the walls: one submap surrounds another. The related work's Voronoi graphs "
        "have fewer map units, of irregular size.";
    figure.setting =
        "All scans on cells of 5 cm. The preset paper is told k = " + std::to_string(count) +
        ", and so is k-means of the leaves' centres; rooms and the Voronoi graph find their own "
        "number. Coupling is measured on the same graph G for all. Times without the mapping.";
    figure.pictures = {
        quadtree_picture("fig15_quadtree.png", world.map, "Fig 15: the quadtree's leaves"),
        graph_picture("fig16_graph.png", contest.graph, world.map,
                      "Fig 16: the graph G, " +
                          in_words(static_cast<double>(contest.graph.leaves.nodes.size())) +
                          " nodes")};
    std::vector<Picture> results = pictures_of(contest, world, "fig17");
    results[0] = plan_picture("fig17_paper.png", world.map, contest.paper.rooms,
                              "Fig 17: " + results[0].caption, links);
    results[0].span = Span::full;
    for (Picture& picture : results) figure.pictures.push_back(std::move(picture));
    figure.tables = {table_of(contest, none(), number(kNumSubmaps))};
    figure.tables[0].rows.push_back({"pairs of submaps with an edge",
                                     "",
                                     {none(), number(links.size()), none(), none(), none()}});
    figure.claims = judge(numbers_of(contest, count));
    return figure;
}

}  // namespace quadcut::reproduce
