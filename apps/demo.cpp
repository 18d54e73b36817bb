// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/simulated_robot.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "draw/filmstrip.hpp"
#include "eval/truth_score.hpp"
#include "formats/registry.hpp"
#include "io/file.hpp"
#include "io/format_version.hpp"
#include "io/number_text.hpp"
#include "project/project.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "sim/write.hpp"

namespace quadcut {
namespace {

constexpr const char* kDefaultFolder = "quadcut_demo";
constexpr const char* kTruthFolder = "simulation/";
constexpr std::size_t kNumMoments = 8;
// What is written beside the results of following.
constexpr const char* kFilmstrip = "filmstrip.png";
constexpr const char* kScore = "score.json";
constexpr const char* kProject = "building.quadcut";

double length_m(const std::vector<Point>& points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
    return sum;
}

std::string percent(double share) { return io::rounded(100.0 * share, 1) + " %"; }

/// What came of following the robot.
struct Followed {
    std::shared_ptr<const Snapshot> building;
    Segmentation rooms;
    /// The file of the project.
    std::string project;
    /// At equal distances in time.
    std::vector<draw::Moment> moments;
};

draw::Moment moment_of(const Project& project) {
    const std::shared_ptr<const Snapshot> building = project.snapshot();
    return {"scan " + std::to_string(project.position()->num_done) + ", " +
                num_rooms_text(building->num_rooms()),
            building->map(), building->rooms(), building->way()};
}

Followed follow_scans(const std::vector<Scan>& scans, const FollowOptions& options,
                      const std::string& name, StageClock& clock, Progress& progress) {
    clock.begin("follow");
    Followed followed;
    ScanPosition position;
    position.source = name;
    Project project = Project::in_memory(options, position);
    for (std::size_t i = 1; i <= scans.size(); ++i) {
        project.add_next(scans[i - 1]);
        progress.update(i, scans.size(),
                        {"scans", [&] { return num_rooms_text(project.state().num_rooms); }});
        const std::size_t next = scans.size() * (followed.moments.size() + 1) / kNumMoments;
        if (i == next && i < scans.size()) followed.moments.push_back(moment_of(project));
    }
    project.finish();
    followed.moments.push_back(moment_of(project));
    clock.begin("doors");
    followed.building = project.snapshot();
    followed.rooms = followed.building->rooms();
    followed.project = project.file_bytes();
    return followed;
}

std::vector<std::string> files_of_demo() {
    std::vector<std::string> files = followed_files();
    files.insert(files.end(), {kFilmstrip, kScore, kProject});
    for (const std::string& name : sim::simulation_files()) files.push_back(kTruthFolder + name);
    return files;
}

std::string score_text(const eval::RoomScore& score) {
    std::string text = eval::to_json(score) + "\n";
    return text.insert(text.find('\n') + 1,
                       " \"format_version\": " + std::to_string(io::kFormatVersion) + ",\n");
}

void write(io::FileBatch& output, const Simulation& simulation, const Followed& followed,
           const eval::RoomScore& score, const io::RunInfo& info) {
    const Uninterrupted uninterrupted;
    sim::add_simulation(output, simulation.building, simulation.options, simulation.exploration,
                        kTruthFolder);
    add_followed(output, *followed.building, followed.rooms, info);
    output.add(kFilmstrip, draw::render_filmstrip(followed.moments));
    output.add(kScore, score_text(score));
    output.add(kProject, followed.project);
    output.commit();
}

void print_story(const std::string& folder, const Simulation& simulation, const Followed& followed,
                 const eval::RoomScore& score, double elapsed_s) {
    const sim::Building& building = simulation.building;
    const Raster<CellState>& cells = followed.building->map().states;
    const Segmentation& rooms = followed.rooms;
    std::cout << "Simulated a furnished building of " << building.rooms.size() << " rooms and "
              << building.doors.size() << " doors (seed " << simulation.options.seed << ").\n"
              << "A robot explored it: " << simulation.exploration.scans.size() << " scans on "
              << io::rounded(length_m(followed.building->way()), 0) << " m of way, mapped to "
              << cells.width << " x " << cells.height << " cells.\n"
              << "Followed it, and cut the map into " << rooms.rooms.size() << " rooms with "
              << rooms.doors.size() << " doors; all of this took " << io::rounded(elapsed_s, 1)
              << " s.\n"
              << "Against the truth: panoptic quality " << percent(score.pq) << ", "
              << percent(score.f1_50) << " of the rooms found, " << percent(score.cover)
              << " of their floor.\n"
              << "Look at " << folder << "/filmstrip.png, " << folder << "/rooms_color.png and "
              << folder << "/rooms.svg; the truth is in " << folder << "/" << kTruthFolder << "\n";
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path folder = output_folder(arguments, kDefaultFolder);
    io::FileBatch output = begin_output(arguments, files_of_demo(), kDefaultFolder);
    SimulationChoice choice;
    set_fields(arguments, simulation_fields(choice));
    Progress progress(progress_style_of(arguments));
    StageClock clock([&progress](std::string_view stage) { progress.begin(stage); });

    clock.begin("simulate");
    const Simulation simulation = simulate(choice, progress);
    FollowOptions options;
    const std::string name = "simulation, seed " + std::to_string(choice.seed);
    Followed followed = follow_scans(simulation.exploration.scans, options, name, clock, progress);
    Segmentation& rooms = followed.rooms;
    clock.begin("score");
    const eval::RoomScore score =
        score_against_truth(followed.building->map(), rooms, simulation.building);
    rooms.report.stages_ms = clock.finish();
    progress.begin("write");
    io::RunInfo info = run_info_of(options, {});
    info.input = name;
    write(output, simulation, followed, score, info);

    progress.wipe();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const SummaryStyle style = summary_style_of(arguments);
    if (style == SummaryStyle::json) {
        print_summary({rooms, {}, start, io::display_name(folder), files_of_demo()}, style);
    }
    if (style == SummaryStyle::text) {
        print_story(io::display_name(folder), simulation, followed, score, elapsed.count());
    }
}

}  // namespace

Command demo_command() {
    SimulationChoice defaults;
    const std::vector<OptionField> fields = simulation_fields(defaults);
    CommandForm form;
    form.name = "demo";
    form.text =
        "Simulates a furnished building, follows a robot in it, and compares rooms with the truth.";
    form.flags = {output_flag(), force_flag(), flag_of(fields, "seed", "S"), json_flag(),
                  quiet_flag()};
    form.flags[0].is_required = false;
    form.flags[0].text += std::string("; ") + kDefaultFolder + " if not given";
    form.examples = {"quadcut demo -o build/demo", "quadcut demo -o another_demo --seed 2"};
    return {form, run};
}

}  // namespace quadcut
