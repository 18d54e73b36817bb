// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Figs 11 and 12: the well-structured workplace, batch and incrementally.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "eval/labels.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/segment.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/map_graph.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

constexpr std::size_t kInnerSubmaps = 5;
constexpr double kMarginM = 2.0;

/// The map as Algorithm 1 sees it, which knows two states: what is not occupied is free, inside or
/// outside.
GridMap with_two_states(const GridMap& map) {
    const auto margin = static_cast<std::int32_t>(kMarginM / map.resolution_m);
    GridMap result = map;
    result.states = Raster<CellState>(map.states.box().grown(margin), CellState::free);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        if (map.states.values[i] == CellState::occupied) {
            result.states.at(map.states.cell(i)) = CellState::occupied;
        }
    }
    // Maps begin at cell (0, 0).
    const Point corner =
        transform(map.map_from_image, {-margin * map.resolution_m, -margin * map.resolution_m});
    result.map_from_image.x = corner.x;
    result.map_from_image.y = corner.y;
    result.states.origin = {0, 0};
    return result;
}

/// Regions most of whose cells are no true room's.
std::size_t count_outside(const Segmentation& rooms, const GridMap& map, const World& world) {
    const Raster<std::uint32_t> truth = labels_at(world.truth_map, world.truth, map);
    std::vector<std::size_t> all(rooms.rooms.size() + 1, 0);
    std::vector<std::size_t> inside(rooms.rooms.size() + 1, 0);
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        ++all[rooms.labels.values[i]];
        if (truth.values[i] != 0) ++inside[rooms.labels.values[i]];
    }
    std::size_t count = 0;
    for (std::size_t region = 1; region < all.size(); ++region) {
        if (2 * inside[region] < all[region]) ++count;
    }
    return count;
}

Value pq_of(const Segmentation& rooms, const GridMap& map, const World& world) {
    const std::optional<double> pq = pq_percent(labels_of_cells(rooms), map, world);
    return pq ? number(*pq, 1) : none();
}

}  // namespace

Figure figure_11(const Worlds& worlds, const Setup& setup) {
    const World& world = worlds.workplace;
    const GridMap map = map_from_scans(world.scans, kWorkplaceResolutionM).to_grid();
    const MapGraph graph = graph_of(map, SelfLoops::none, setup.executor());
    const GridMap open_map = with_two_states(map);
    const Segmentation chosen =
        as_submaps(segment(map, setup.paper(0), setup.run, world.trajectory));
    const Segmentation told = segment(map, setup.paper(kInnerSubmaps), setup.run);
    const Segmentation open = as_submaps(segment(open_map, setup.paper(0), setup.run));
    const Segmentation rooms = segment(map, setup.rooms(), setup.run, world.trajectory);
    const std::size_t num_outside = count_outside(open, open_map, world);
    const std::size_t num_inside = open.rooms.size() - num_outside;

    Figure figure;
    figure.number = "11";
    figure.title = "Quadtree, graph and submaps of a well-structured workplace";
    figure.paper =
        "Laser scans, the graph G, the quadtree and the submaps: five inner ones of high cohesion "
        "and low coupling. Inside and outside are not told apart, so the outside is divided, too.";
    figure.setting =
        "The simulated workplace on cells of 10 cm. Only seen cells are free; the last picture "
        "takes all that is not occupied for free, as the paper's Algorithm 1 does.";
    figure.pictures = {
        scans_picture("fig11_scans.png", world.scans, map, "(a) Laser scans and the robot's way"),
        quadtree_picture("fig11_quadtree.png", map, "The quadtree: its leaves"),
        graph_picture("fig11_graph.png", graph, map,
                      "The graph G: " + in_words(static_cast<double>(graph.leaves.nodes.size())) +
                          " free leaves"),
        plan_picture("fig11_paper.png", map, chosen, "(d) Submaps, preset paper, by silhouette"),
        plan_picture("fig11_rooms.png", map, rooms, "Preset rooms"),
        plan_picture("fig11_outside.png", open_map, open,
                     "Preset paper, two states: the outside is divided, too")};
    figure.tables = {
        {"",
         {"the paper", "preset paper", "preset paper, told five", "preset rooms",
          "preset paper, two states"},
         {{"inner submaps",
           "",
           {number(kInnerSubmaps), number(chosen.rooms.size()), number(told.rooms.size()),
            number(rooms.rooms.size()), number(num_inside)}},
          {"outer submaps",
           "",
           {words("several"), number(std::size_t{0}), number(std::size_t{0}),
            number(std::size_t{0}), number(num_outside)}},
          {"PQ against the five rooms",
           "%",
           {none(), pq_of(chosen, map, world), pq_of(told, map, world), pq_of(rooms, map, world),
            pq_of(open, open_map, world)}}}}};
    const double pq_told = *pq_percent(labels_of_cells(told), map, world);
    const std::string chosen_count = std::to_string(chosen.rooms.size());
    figure.claims = {
        {chosen.rooms.size() == kInnerSubmaps,
         "by silhouette the preset paper makes " + chosen_count + " inner submaps of the five"},
        {told.rooms.size() == kInnerSubmaps && pq_told >= kAlikePercent,
         "told to make five, it makes " + std::to_string(told.rooms.size()) +
             " that match the rooms with a PQ of " + in_words(pq_told) + " %"},
        {num_outside >= 2, "with two states the outside becomes " + std::to_string(num_outside) +
                               (num_outside == 1 ? " submap" : " submaps")}};
    return figure;
}

Figure figure_12(const Worlds& worlds, const FollowedTwice& workplace, const Setup& setup) {
    const World& world = worlds.workplace;
    const Followed& paper = workplace.paper;
    const Followed& rooms = workplace.rooms;
    // What Fig 11 shows.
    const GridMap map = map_from_scans(world.scans, kWorkplaceResolutionM).to_grid();
    const Segmentation batch_paper = segment(map, setup.paper(0), setup.run, world.trajectory);
    const GridMap fine_map = map_from_scans(world.scans, kResolutionM).to_grid();
    const Segmentation batch_rooms = segment(fine_map, setup.rooms(), setup.run, world.trajectory);
    const double like_paper = agreement_percent(paper.map(), paper.rooms(), map, batch_paper);
    const double like_rooms = agreement_percent(rooms.map(), rooms.rooms(), fine_map, batch_rooms);

    Figure figure;
    figure.number = "12";
    figure.title = "The same, scan by scan";
    figure.paper =
        "While the robot explores, submaps are divided and combined; the final result is similar "
        "to that of Fig 11. Submaps that the robot's way does not cross are no part of the map.";
    figure.setting = "The " + std::to_string(world.scans.size()) +
                     " scans of the workplace, followed; eight moments at equal numbers of scans. "
                     "Preset paper on cells of 10 cm, rooms of 5 cm.";
    figure.pictures = {{"fig12_paper.png", draw::render_filmstrip(paper.moments), "Preset paper"},
                       {"fig12_rooms.png", draw::render_filmstrip(rooms.moments), "Preset rooms"}};
    figure.tables = {
        {"",
         {"the paper", "preset paper", "preset rooms"},
         {{"submaps at the end",
           "",
           {number(kInnerSubmaps), number(paper.rooms().rooms.size()),
            number(rooms.rooms().rooms.size())}},
          {"like the result of Fig 11, PQ",
           "%",
           {words("similar"), number(like_paper, 1), number(like_rooms, 1)}},
          {"PQ against the five rooms",
           "%",
           {none(), pq_of(paper.rooms(), paper.map(), world),
            pq_of(rooms.rooms(), rooms.map(), world)}},
          {"median time of a cut",
           "ms",
           {none(), number(median(paper.cuts_ms), 1), number(median(rooms.cuts_ms), 1)}}}}};
    figure.claims = {
        {like_paper >= kAlikePercent, "followed in the preset paper, the result has a PQ of " +
                                          in_words(like_paper) + " % against that of Fig 11"},
        {like_rooms >= kAlikePercent, "in the preset rooms one of " + in_words(like_rooms) + " %"},
        {paper.rooms().rooms.size() == kInnerSubmaps,
         "it ends with " + std::to_string(paper.rooms().rooms.size()) + " submaps for five rooms"}};
    return figure;
}

}  // namespace quadcut::reproduce
