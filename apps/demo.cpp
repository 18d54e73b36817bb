// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/follow_session.hpp"
#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/simulated_robot.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "draw/filmstrip.hpp"
#include "eval/truth_score.hpp"
#include "formats/results.hpp"
#include "io/file.hpp"
#include "io/format_version.hpp"
#include "io/number_text.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/follower.hpp"
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

std::vector<Point> positions(const std::vector<Scan>& scans) {
    std::vector<Point> points;
    points.reserve(scans.size());
    for (const Scan& scan : scans) {
        points.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    return points;
}

double length_m(const std::vector<Point>& points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
    return sum;
}

std::string percent(double share) { return io::rounded(100.0 * share, 1) + " %"; }

/// What the robot saw, as a map.
struct RobotMap {
    GridMap map;
    std::vector<Point> trajectory;
};

/// What came of following the robot.
struct Followed {
    RobotMap robot;
    Segmentation rooms;
    std::string updates;
    /// The file of the project.
    std::string project;
    /// At equal distances in time.
    std::vector<draw::Moment> moments;
};

draw::Moment moment_of(const FollowSession& session, const std::vector<Point>& way) {
    const std::size_t num_rooms = session.follower().num_rooms();
    draw::Moment moment{"scan " + std::to_string(session.num_done()) + ", " +
                            std::to_string(num_rooms) + (num_rooms == 1 ? " room" : " rooms"),
                        session.follower().map().to_grid(), session.follower().rooms(), way};
    moment.way.resize(session.num_done());
    return moment;
}

Followed follow_scans(const std::vector<Scan>& scans, const FollowOptions& options,
                      const std::string& name, StageClock& clock, Progress& progress) {
    clock.begin("follow");
    Followed followed;
    followed.robot.trajectory = positions(scans);
    store::LogPosition position;
    position.log = name;
    FollowSession session(options, scans, {},
                          store::Project::in_memory(kProject, options, position));
    while (!session.is_done()) {
        session.add_next();
        progress.update(session.num_done(), scans.size(),
                        {"scans", [&session] { return session.story(); }});
        const std::size_t next = scans.size() * (followed.moments.size() + 1) / kNumMoments;
        if (session.num_done() == next && !session.is_done()) {
            followed.moments.push_back(moment_of(session, followed.robot.trajectory));
        }
    }
    session.finish();
    followed.moments.push_back(moment_of(session, followed.robot.trajectory));
    clock.begin("doors");
    followed.robot.map = session.follower().map().to_grid();
    followed.rooms = session.follower().rooms();
    followed.updates = session.updates();
    followed.project = session.project_bytes();
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
    add_followed(output, followed.robot.map, followed.rooms, followed.updates, info);
    output.add(kFilmstrip, draw::render_filmstrip(followed.moments));
    output.add(kScore, score_text(score));
    output.add(kProject, followed.project);
    output.commit();
}

void print_story(const std::string& folder, const Simulation& simulation, const RobotMap& robot,
                 const Segmentation& rooms, const eval::RoomScore& score, double elapsed_s) {
    const sim::Building& building = simulation.building;
    const Raster<CellState>& cells = robot.map.states;
    std::cout << "Simulated a furnished building of " << building.rooms.size() << " rooms and "
              << building.doors.size() << " doors (seed " << simulation.options.seed << ").\n"
              << "A robot explored it: " << simulation.exploration.scans.size() << " scans on "
              << io::rounded(length_m(robot.trajectory), 0) << " m of way, mapped to "
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
    const FollowOptions options;
    const std::string name = "simulation, seed " + std::to_string(choice.seed);
    Followed followed = follow_scans(simulation.exploration.scans, options, name, clock, progress);
    const RobotMap& robot = followed.robot;
    Segmentation& rooms = followed.rooms;
    clock.begin("score");
    const eval::RoomScore score = score_against_truth(robot.map, rooms, simulation.building);
    rooms.report.stages_ms = clock.finish();
    progress.begin("write");
    SegmentOptions segment_options = options.segment;
    io::RunInfo info = run_info_of(segment_options);
    info.input = name;
    write(output, simulation, followed, score, info);

    progress.wipe();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const SummaryStyle style = summary_style_of(arguments);
    if (style == SummaryStyle::json) {
        print_summary({rooms, {}, start, io::display_name(folder), files_of_demo()}, style);
    }
    if (style == SummaryStyle::text) {
        print_story(io::display_name(folder), simulation, robot, rooms, score, elapsed.count());
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
