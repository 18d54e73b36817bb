// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Fig 11: the well-structured workplace.
#include <algorithm>
#include <string>
#include <vector>

#include "eval/labels.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/segment.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/map_graph.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

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

/// The weight that leaves a submap, mean, over that which leaves a true room; on the graph of what
/// was seen, so that the outside plays no part.
double coupling_ratio(const MapGraph& graph, const Segmentation& rooms, const GridMap& rooms_map,
                      const GridMap& map, const World& world) {
    const Quality made = quality_of(graph, labels_at(rooms_map, rooms.labels, map), map, world);
    const Quality truth =
        quality_of(graph, labels_at(world.truth_map, world.truth, map), map, world);
    return made.coupling_percent / truth.coupling_percent;
}

}  // namespace

Figure figure_11(const Worlds& worlds, const Setup& setup) {
    const World& world = worlds.workplace;
    const GridMap map = map_from_scans(world.scans, world.paper_cell_m).to_grid();
    const MapGraph graph = graph_of(map, SelfLoops::none, setup.executor());
    const GridMap open_map = with_two_states(map);
    const Segmentation chosen =
        as_submaps(segment(map, setup.paper(0), setup.run, world.trajectory));
    const Segmentation told = segment(map, setup.paper(kPaperInnerSubmaps), setup.run);
    const Segmentation open = as_submaps(segment(open_map, setup.paper_by_silhouette(), setup.run));
    const Segmentation rooms = segment(map, setup.rooms(), setup.run, world.trajectory);
    // The paper speaks of the main area: what is made of the outside is no part of its claim.
    World main_area = world;
    main_area.is_void_judged = false;
    const std::optional<double> open_pq = pq_percent(open, open_map, main_area);
    const std::size_t num_outside = count_outside(open, open_map, world);
    const std::size_t num_inside = open.rooms.size() - num_outside;

    Figure figure;
    figure.number = "11";
    figure.title = "Quadtree, graph and submaps of a well-structured workplace";
    figure.paper =
        "Laser scans, the graph G, the quadtree and the submaps: five inner ones of high cohesion "
        "and low coupling. Inside and outside are not told apart, so the outside is divided, too.";
    figure.setting =
        "The simulated workplace on cells of " + in_words(100.0 * world.paper_cell_m) +
        " cm. The claims are about the paper's own setting, two states: as in its Algorithm 1 all "
        "that is not occupied is free, inside and outside, and the number is by silhouette. "
        "quadcut's third state, unknown, leaves the outside out; it stands beside it.";
    figure.pictures = {
        scans_picture("fig11_scans.png", world.scans, map, "(a) Laser scans and the robot's way"),
        quadtree_picture("fig11_quadtree.png", map, "The quadtree: its leaves"),
        graph_picture("fig11_graph.png", graph, map,
                      "The graph G: " + in_words(static_cast<double>(graph.leaves.nodes.size())) +
                          " free leaves"),
        plan_picture("fig11_paper.png", open_map, open,
                     "(d) Submaps, two states, number by silhouette: the outside is divided, too"),
        plan_picture("fig11_unknown.png", map, chosen,
                     "Preset paper as it is: three states, only what was seen is free"),
        plan_picture("fig11_rooms.png", map, rooms, "Preset rooms")};
    figure.tables = {
        {"",
         {"the paper", "preset paper, two states, silhouette", "preset paper",
          "preset paper, told five", "preset rooms"},
         {{"inner submaps",
           "",
           {number(kPaperInnerSubmaps), number(num_inside), number(chosen.rooms.size()),
            number(told.rooms.size()), number(rooms.rooms.size())}},
          {"outer submaps",
           "",
           {words("several"), number(num_outside), number(std::size_t{0}), number(std::size_t{0}),
            number(std::size_t{0})}},
          {"PQ against the five rooms, without the outside",
           "%",
           {none(), number(open_pq, 1), number(pq_percent(chosen, map, world), 1),
            number(pq_percent(told, map, world), 1), number(pq_percent(rooms, map, world), 1)}}}}};
    figure.claims = judge(WorkplaceNumbers{static_cast<double>(num_inside),
                                           static_cast<double>(num_outside), open_pq.value_or(0.0),
                                           coupling_ratio(graph, open, open_map, map, world)});
    return figure;
}

}  // namespace quadcut::reproduce
