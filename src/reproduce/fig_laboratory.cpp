// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Figs 20 to 22: a robot in a cluttered laboratory.
#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "eval/labels.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "reproduce/contest.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

std::size_t num_true_rooms(const World& world, const GridMap& map) {
    const Raster<std::uint32_t> truth = labels_at(world.truth_map, world.truth, map);
    std::set<std::uint32_t> rooms(truth.values.begin(), truth.values.end());
    rooms.erase(0);
    return rooms.size();
}

/// The moment when half of the scans were there.
const draw::Moment& half(const Followed& followed) {
    return followed.moments[(followed.moments.size() - 1) / 2];
}

double half_like_end(const Followed& followed) {
    return agreement_percent(half(followed).map, half(followed).rooms, followed.map(),
                             followed.rooms());
}

std::size_t cut_rooms(const Followed& followed, const World& world) {
    return count_cut_rooms(labels_of_cells(followed.rooms()), followed.map(), world);
}

/// Connected obstacles that are shorter than 2 m, on a square metre of floor: desks, chairs, boxes
/// and what a laser makes of them.
double clutter_of(const GridMap& map) {
    constexpr double kShortM = 2.0;
    const ConnectedParts parts = connected_parts(
        map.states, [&](std::size_t i) { return map.states.values[i] == CellState::occupied; },
        Connectivity::eight);
    std::vector<Box> boxes(parts.count + 1);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        const Cell begin = map.states.cell(first);
        boxes[run.part].include(
            {begin, {begin.x + static_cast<std::int32_t>(run.end - run.begin) - 1, begin.y}});
    });
    const auto num_short = std::count_if(boxes.begin() + 1, boxes.end(), [&](const Box& box) {
        return std::max(box.width(), box.height()) * map.resolution_m < kShortM;
    });
    const auto num_free =
        std::count(map.states.values.begin(), map.states.values.end(), CellState::free);
    return static_cast<double>(num_short) /
           (static_cast<double>(num_free) * map.resolution_m * map.resolution_m);
}

Table clutter_table(const Worlds& worlds) {
    Table table{"How cluttered", {}, {{"obstacles shorter than 2 m on a square metre", "", {}}}};
    for (const World* world : {&worlds.laboratory, &worlds.mit_csail, &worlds.intel}) {
        table.columns.push_back(world->name);
        table.rows[0].values.push_back(number(clutter_of(world->map), 2));
    }
    return table;
}

Table followed_table(const World& world, const Followed& paper, const Followed& rooms) {
    return {"Followed",
            {"the paper", "preset paper", "preset rooms"},
            {{"submaps at half the way (Fig 21)",
              "",
              {number(kPaperHalfSubmaps), number(half(paper).rooms.rooms.size()),
               number(half(rooms).rooms.rooms.size())}},
             {"like the final result where both are, PQ",
              "%",
              {words("very similar"), number(half_like_end(paper), 1),
               number(half_like_end(rooms), 1)}},
             {"submaps at the end (Fig 22)",
              "",
              {none(), number(paper.rooms().rooms.size()), number(rooms.rooms().rooms.size())}},
             {"true rooms that were seen",
              "",
              {none(), number(num_true_rooms(world, paper.map())),
               number(num_true_rooms(world, rooms.map()))}},
             {"true rooms that are cut apart",
              "",
              {words("some"), number(cut_rooms(paper, world)), number(cut_rooms(rooms, world))}},
             {"PQ against the true rooms at the end",
              "%",
              {none(), number(pq_percent(paper.rooms(), paper.map(), world), 1),
               number(pq_percent(rooms.rooms(), rooms.map(), world), 1)}},
             {"median time of a cut",
              "ms",
              {none(), number(median(heights(paper.cut_ms)), 1),
               number(median(heights(rooms.cut_ms)), 1)}}}};
}

}  // namespace

Figure figures_20_to_22(const Worlds& worlds, const FollowedTwice& laboratory, const Setup& setup) {
    const World& world = worlds.laboratory;
    const Followed& paper = laboratory.paper;
    const Followed& rooms = laboratory.rooms;
    const Contest contest = hold_contest(world, 0, setup);

    Figure figure;
    figure.number = "20-22";
    figure.title = "A robot in a cluttered laboratory";
    figure.paper =
        "A PeopleBot with a Hokuyo UST-10LX in a laboratory full of partitions and debris: the "
        "quadtree, four temporary submaps at half the way, very similar to the final ones, which "
        "fit the structure of the rooms. Tables and chairs count as walls and cut rooms apart.";
    figure.setting =
        "The paper's data is not public. " +
        std::string(world.is_simulated
                        ? "Without --data a simulated robot drives through a simulated laboratory "
                          "full of furniture. "
                        : "In its place stands the log of a real robot on a floor of the same "
                          "kind: MIT-CSAIL's open-plan laboratory, divided by partitions and "
                          "desks, every scan that the robot took. Of the buildings with logs it "
                          "is the most cluttered that is not corridors alone. True rooms are "
                          "drawn by hand; what nobody could name is not judged. ") +
        "Followed in the preset paper on cells of " + in_words(100.0 * world.paper_cell_m) +
        " cm, rooms of 5 cm; then the whole map, cut by all methods.";
    figure.pictures = {
        scans_picture("fig20_scans.png", world.scans, world.map, "What the robot saw, and its way"),
        quadtree_picture("fig20_quadtree.png", world.map, "Fig 20: the quadtree's leaves"),
        plan_picture("fig21_paper.png", half(paper).map, half(paper).rooms,
                     "Fig 21: half the way, preset paper, " + half(paper).caption),
        plan_picture("fig21_rooms.png", half(rooms).map, half(rooms).rooms,
                     "Half the way, preset rooms, " + half(rooms).caption),
        plan_picture("fig22_paper.png", paper.map(), paper.rooms(),
                     "Fig 22: the end, preset paper, " + paper.moments.back().caption),
        plan_picture("fig22_rooms.png", rooms.map(), rooms.rooms(),
                     "The end, preset rooms, " + rooms.moments.back().caption)};
    // The paper's own two are to be read.
    figure.pictures[2].span = Span::full;
    figure.pictures[4].span = Span::full;
    std::vector<Picture> whole = pictures_of(contest, world, "fig22_whole");
    for (Picture& picture : whole) {
        picture.caption = "Whole map. " + picture.caption;
        figure.pictures.push_back(std::move(picture));
    }
    figure.tables = {followed_table(world, paper, rooms), table_of(contest, none(), none()),
                     clutter_table(worlds)};
    figure.tables[1].title = "The whole map at once";
    const std::optional<double> pq = pq_percent(paper.rooms(), paper.map(), world);
    figure.claims = judge(LaboratoryNumbers{half_like_end(paper),
                                            static_cast<double>(half(paper).rooms.rooms.size()),
                                            pq.value_or(0.0),
                                            {static_cast<double>(cut_rooms(paper, world)),
                                             static_cast<double>(cut_rooms(rooms, world))}});
    return figure;
}

}  // namespace quadcut::reproduce
