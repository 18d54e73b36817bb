// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/reproduce.hpp"

#include <chrono>
#include <utility>

#include "io/file_batch.hpp"
#include "quadcut/version.hpp"
#include "reproduce/commit.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/timing.hpp"

namespace quadcut::reproduce {
namespace {

constexpr std::size_t kNumParts = 18;
constexpr std::size_t kNumMoments = 6;
// The preset `paper` follows on cells with which its graphs are as large as those that the paper
// speaks of, some hundred nodes; one building it follows on the fine cells of all else.
constexpr double kMiddleCellM = 0.1;
constexpr double kCoarseCellM = 0.2;

/// Counts the parts.
class Parts {
public:
    explicit Parts(const OnPart& on_part) : on_part_(on_part) {}
    void begin(std::string_view part) {
        if (on_part_) on_part_(part, num_begun_, kNumParts);
        ++num_begun_;
    }

private:
    const OnPart& on_part_;
    std::size_t num_begun_ = 0;
};

Worlds make_worlds(const Options& options, Parts& parts) {
    Worlds worlds;
    parts.begin("workplace");
    worlds.workplace = workplace(options.seed);
    parts.begin("MIT-CSAIL");
    worlds.mit_csail = mit_csail(options.data, options.size, options.seed);
    parts.begin("Intel");
    worlds.intel = intel(options.data, options.size, options.seed);
    parts.begin("laboratory");
    worlds.laboratory = laboratory(options.data, options.size, options.seed);
    const bool is_small = options.size == Size::small;
    worlds.workplace.paper_cell_m = is_small ? kCoarseCellM : kMiddleCellM;
    worlds.mit_csail.paper_cell_m = is_small ? kCoarseCellM : kResolutionM;
    worlds.intel.paper_cell_m = kCoarseCellM;
    worlds.laboratory.paper_cell_m = is_small ? kCoarseCellM : kMiddleCellM;
    return worlds;
}

FollowedTwice follow_twice(const World& world, const Setup& setup) {
    return {follow(world, setup.paper(0), setup.run, world.paper_cell_m, kNumMoments),
            follow(world, setup.rooms(), setup.run, kResolutionM, kNumMoments)};
}

FollowedWorlds follow_worlds(const Worlds& worlds, const Setup& setup, Parts& parts) {
    FollowedWorlds followed;
    parts.begin("following: workplace");
    followed.workplace = follow_twice(worlds.workplace, setup);
    parts.begin("following: MIT-CSAIL");
    followed.mit_csail = follow_twice(worlds.mit_csail, setup);
    parts.begin("following: Intel");
    followed.intel = follow_twice(worlds.intel, setup);
    parts.begin("following: laboratory");
    followed.laboratory = follow_twice(worlds.laboratory, setup);
    return followed;
}

}  // namespace

Report measure(const Options& options, const OnPart& on_part) {
    const auto start = std::chrono::steady_clock::now();
    Parts parts(on_part);
    const Setup setup{{options.num_threads}, options.seed, options.size};
    Report report;
    report.version = kVersion;
    report.commit = built_commit();
    report.command = options.command;
    report.machine = this_machine();
    report.num_threads = options.num_threads;
    report.seed = options.seed;
    report.is_simulated = !options.data;
    const Worlds worlds = make_worlds(options, parts);
    for (const World* world :
         {&worlds.workplace, &worlds.mit_csail, &worlds.intel, &worlds.laboratory}) {
        report.worlds.push_back(world->origin);
    }
    const auto add = [&](std::string_view part, auto&& figure_of) {
        parts.begin(part);
        report.figures.push_back(figure_of());
    };
    add("Fig 4", [&] { return figure_4(worlds, setup); });
    add("Fig 6", [&] { return figure_6(worlds, setup); });
    add("Fig 7", [&] { return figure_7(worlds, setup); });
    add("Fig 11", [&] { return figure_11(worlds, setup); });
    const FollowedWorlds followed = follow_worlds(worlds, setup, parts);
    add("Fig 12", [&] { return figure_12(worlds, followed); });
    add("Fig 13", [&] { return figure_13(worlds); });
    add("Fig 14", [&] { return figure_14(worlds, followed); });
    add("Figs 15-17", [&] { return figures_15_to_17(worlds, setup); });
    add("Fig 18", [&] {
        IntelResult result = figure_18(worlds, followed.intel, setup);
        report.headlines = std::move(result.headlines);
        return std::move(result.figure);
    });
    add("Figs 20-22", [&] { return figures_20_to_22(worlds, followed.laboratory, setup); });
    report.elapsed_s = ms_since(start) / 1000.0;
    return report;
}

std::vector<std::string> main_files() { return {"index.html", "reproduce.json"}; }

void add_files(io::FileBatch& files, const Report& report) {
    for (const Figure& figure : report.figures) {
        for (const Picture& picture : figure.pictures) files.add(picture.file, picture.bytes);
    }
    files.add("reproduce.json", to_json(report));
    files.add("index.html", html_page(report));
}

}  // namespace quadcut::reproduce
