// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "eval/score.hpp"
#include "io/label_image.hpp"
#include "io/map_server.hpp"
#include "tests/e2e/labels.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

const std::vector<std::string> kBuildings{"Freiburg101_scan", "NLB",     "lab_c_scan", "lab_f_scan",
                                          "lab_intel",        "lab_ipa", "office_a",   "office_b",
                                          "office_e",         "office_h"};
const std::vector<std::string> kFloors{"kth_50010535_PLAN1", "kth_50015847", "kth_50052748",
                                       "kth_50052751"};

/// Segments data/rooms/NAME.KIND.yaml with the defaults and scores the result.
eval::RoomScore score_of(const Folder& folder, const std::string& name, const std::string& kind) {
    const std::filesystem::path map = shared("data/rooms/" + name + "." + kind + ".yaml");
    const std::string out = folder / (name + "." + kind);
    const Outcome outcome = run_quadcut({"segment", map.string(), "-o", out});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    if (outcome.exit_code != 0) return {};
    for (const auto& [label, parts] : num_parts_by_label(read_labels(out + "/rooms.png"))) {
        EXPECT_EQ(parts, 1) << name << "." << kind << ": room " << label << " is not connected";
    }
    return eval::score_rooms(
        io::read_label_image(out + "/rooms.png"),
        io::read_label_image(shared("data/rooms/" + name + ".rooms.png")),
        io::read_free_mask(shared("data/rooms/" + name + "." + kind + ".png")));
}

/// Mean panoptic quality, per cent; every map must be covered.
double mean_pq(const std::vector<std::string>& names, const std::string& kind) {
    const Folder folder;
    double sum = 0.0;
    for (const std::string& name : names) {
        const eval::RoomScore score = score_of(folder, name, kind);
        EXPECT_GE(score.cover, 0.98) << name << "." << kind;
        std::printf("%-28s pq %.1f cover %.3f rooms %u truth %u\n", (name + "." + kind).c_str(),
                    100.0 * score.pq, score.cover, score.rooms, score.truth);
        sum += score.pq;
    }
    std::printf("%-28s pq %.1f\n", ("mean of " + kind).c_str(),
                100.0 * sum / static_cast<double>(names.size()));
    return 100.0 * sum / static_cast<double>(names.size());
}

bool have_rooms() { return std::filesystem::exists(shared("data/rooms/NLB.rooms.png")); }
constexpr const char* kNoRooms = "no maps with true rooms beside the repository (data/rooms)";

TEST(SlowRealMaps, PlainBuildings) {
    if (!have_rooms()) GTEST_SKIP() << kNoRooms;
    EXPECT_GE(mean_pq(kBuildings, "plain"), 86.0);
}

TEST(SlowRealMaps, FurnishedBuildings) {
    if (!have_rooms()) GTEST_SKIP() << kNoRooms;
    EXPECT_GE(mean_pq(kBuildings, "furnished"), 83.0);
}

TEST(SlowRealMaps, LargeFloors) {
    if (!have_rooms()) GTEST_SKIP() << kNoRooms;
    // What a clearance watershed reaches without help from the truth.
    EXPECT_GE(mean_pq(kFloors, "plain"), 85.0);
}

TEST(SlowRealMaps, EveryOtherMapGivesConnectedRooms) {
    if (!std::filesystem::exists(shared("data/maps"))) GTEST_SKIP() << "no data/maps";
    const Folder folder;
    for (const std::string name :
         {"aws_small_house.yaml", "nav2_depot.yaml", "turtlebot3_world.yaml",
          "ubremen_cartesium.yaml", "willow_full_stage.pgm"}) {
        const std::string out = folder / name;
        const Outcome outcome =
            run_quadcut({"segment", shared("data/maps/" + name).string(), "-o", out});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const auto parts = num_parts_by_label(read_labels(out + "/rooms.png"));
        EXPECT_FALSE(parts.empty()) << name;
        for (const auto& [label, count] : parts) EXPECT_EQ(count, 1) << name << ": " << label;
    }
}

/// The numbers that a command prints as JSON.
nlohmann::json numbers_of(const std::string& program, const std::vector<std::string>& arguments) {
    const Outcome outcome = run_process(program, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

/// What the program says of these files is what the script says.
void expect_same_numbers(const std::vector<std::string>& files) {
    std::vector<std::string> ours{"score"};
    ours.insert(ours.end(), files.begin(), files.end());
    std::vector<std::string> theirs{shared("eval/score_rooms.py").string()};
    theirs.insert(theirs.end(), files.begin(), files.end());
    const nlohmann::json a = numbers_of(QUADCUT_BINARY, ours);
    const nlohmann::json b = numbers_of(QUADCUT_PYTHON, theirs);
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [key, value] : b.items()) {
        EXPECT_NEAR(a.at(key).get<double>(), value.get<double>(), 1e-9)
            << key << " of " << files.at(files.size() - 2);
    }
}

TEST(SlowScore, SameNumbersAsTheScript) {
    if (!have_rooms() || !std::filesystem::exists(shared("eval/score_rooms.py"))) {
        GTEST_SKIP() << kNoRooms;
    }
    const Folder folder;
    for (const std::string name : {"NLB.furnished", "lab_ipa.plain", "kth_50052748.plain"}) {
        const std::string base = name.substr(0, name.find('.'));
        const std::string map = shared("data/rooms/" + name + ".png").string();
        const std::string truth = shared("data/rooms/" + base + ".rooms.png").string();
        const std::string yaml = shared("data/rooms/" + name + ".yaml").string();
        ASSERT_EQ(run_quadcut({"segment", yaml, "-o", folder / name}).exit_code, 0);
        const std::string predicted = folder / (name + "/rooms.png");
        const std::vector<std::vector<std::string>> runs = {
            {predicted, truth, map}, {predicted, truth}, {truth, predicted}, {map, truth}};
        for (const std::vector<std::string>& files : runs) expect_same_numbers(files);
    }
}

TEST(SlowScore, SameNumbersAsTheScriptWithoutTheVoid) {
    const std::filesystem::path real = shared("data/real");
    if (!std::filesystem::exists(real) || !std::filesystem::exists(shared("eval/score_rooms.py"))) {
        GTEST_SKIP() << kNoRooms;
    }
    const Folder folder;
    for (const std::string name : {"intel_dense", "intel_slam_b", "fr101", "willow_full_stage"}) {
        const std::string map = real / (name + ".png");
        const std::string truth = real / (name + ".rooms.png");
        ASSERT_EQ(run_quadcut({"segment", real / (name + ".yaml"), "-o", folder / name}).exit_code,
                  0);
        const std::string predicted = folder / (name + "/rooms.png");
        expect_same_numbers({"--void", predicted, truth, map});
        expect_same_numbers({"--void", predicted, truth});
        expect_same_numbers({"--void", truth, predicted, map});
    }
}

}  // namespace
}  // namespace quadcut::test
