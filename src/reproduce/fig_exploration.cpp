// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Fig 12: submaps while the robot explores.
#include <string>
#include <utility>
#include <vector>

#include "reproduce/experiments.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

/// So few in a row that they can be read where the strip is as wide as the page.
constexpr std::size_t kPerRow = 3;

std::size_t count_in_all(const Followed& followed) {
    std::size_t count = 0;
    for (const draw::Moment& moment : followed.moments) count += count_uncrossed(moment);
    return count;
}

Table table_of(const World& world, const FollowedTwice& twice, const Value& paper_submaps) {
    const auto row = [&twice](const char* name, const char* unit, const Value& said,
                              const auto& value_of) {
        return Row{name, unit, {said, value_of(twice.paper), value_of(twice.rooms)}};
    };
    return {
        world.name,
        {"the paper", "preset paper", "preset rooms"},
        {row("regions at the end", "", paper_submaps,
             [](const Followed& f) { return number(f.rooms().rooms.size()); }),
         row("regions, the same map at once", "", none(),
             [](const Followed& f) { return number(f.at_once.rooms.size()); }),
         row("followed against at once, PQ", "%", words("similar"),
             [](const Followed& f) { return number(likeness_percent(f.rooms(), f.at_once), 1); }),
         row("regions that the way does not cross, all moments", "", number(std::size_t{0}),
             [](const Followed& f) { return number(count_in_all(f)); }),
         row("PQ against the true rooms", "%", none(),
             [&world](const Followed& f) {
                 return number(pq_percent(f.rooms(), f.map(), world), 1);
             }),
         row("median time of a cut", "ms", none(),
             [](const Followed& f) { return number(median(heights(f.cut_ms)), 1); })}};
}

Picture strip(const std::string& file, const Followed& followed, const std::string& caption) {
    return {file, draw::render_filmstrip(followed.moments, kPerRow), caption, Span::full};
}

}  // namespace

Figure figure_12(const Worlds& worlds, const FollowedWorlds& followed) {
    const std::vector<std::pair<const World*, const FollowedTwice*>> all{
        {&worlds.workplace, &followed.workplace},
        {&worlds.mit_csail, &followed.mit_csail},
        {&worlds.intel, &followed.intel},
        {&worlds.laboratory, &followed.laboratory}};
    Figure figure;
    figure.number = "12";
    figure.title = "The same, scan by scan";
    figure.paper =
        "While the robot explores, submaps are divided and combined; the final result is similar "
        "to that of Fig 11. Submaps that the robot's way does not cross are no part of the map.";
    figure.setting =
        "The scans of four worlds, followed, and then the same map cut at once. Side "
        "of a cell in the preset paper:";
    ExplorationNumbers numbers;
    for (const auto& [world, twice] : all) {
        figure.setting += " " + world->name + " " + in_words(100.0 * world->paper_cell_m) + " cm,";
        const bool is_workplace = world == &worlds.workplace;
        figure.tables.push_back(
            table_of(*world, *twice, is_workplace ? number(kPaperInnerSubmaps) : none()));
        numbers.paper_like_batch.push_back(
            {world->name, likeness_percent(twice->paper.rooms(), twice->paper.at_once)});
        numbers.rooms_like_batch.push_back(
            {world->name, likeness_percent(twice->rooms.rooms(), twice->rooms.at_once)});
        numbers.num_uncrossed.push_back(
            {world->name, static_cast<double>(count_in_all(twice->paper))});
    }
    figure.setting += " 5 cm in rooms, which keeps what was only seen through a door.";
    numbers.num_submaps = static_cast<double>(followed.workplace.paper.rooms().rooms.size());
    figure.pictures = {
        strip("fig12_paper.png", followed.workplace.paper, "Workplace, preset paper"),
        strip("fig12_rooms.png", followed.workplace.rooms, "Workplace, preset rooms"),
        strip("fig12_csail_paper.png", followed.mit_csail.paper,
              worlds.mit_csail.name + ", preset paper")};
    figure.claims = judge(numbers);
    return figure;
}

}  // namespace quadcut::reproduce
