// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "io/map_server.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/rooms/rooms.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/segment.hpp"
#include "tests/e2e/labels.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// The state at a point of the map frame; unknown outside.
CellState state_at(const GridMap& map, const Point& point) {
    const Point in_image = transform(inverse(map.map_from_image), point);
    const Cell cell{
        map.states.origin.x + static_cast<std::int32_t>(std::floor(in_image.x / map.resolution_m)),
        map.states.origin.y + static_cast<std::int32_t>(std::floor(in_image.y / map.resolution_m))};
    return map.states.contains(cell) ? map.states.at(cell) : CellState::unknown;
}

/// Intersection over union of the free space of two maps, where both are known, by the cells of the
/// first.
double free_iou(const GridMap& a, const GridMap& b) {
    std::size_t both = 0;
    std::size_t either = 0;
    for (std::size_t i = 0; i < a.states.values.size(); ++i) {
        const Cell cell = a.states.cell(i);
        const Point center =
            transform(a.map_from_image, {(cell.x - a.states.origin.x + 0.5) * a.resolution_m,
                                         (cell.y - a.states.origin.y + 0.5) * a.resolution_m});
        const CellState in_a = a.states.values[i];
        const CellState in_b = state_at(b, center);
        if (in_a == CellState::unknown || in_b == CellState::unknown) continue;
        if (in_a == CellState::free && in_b == CellState::free) ++both;
        if (in_a == CellState::free || in_b == CellState::free) ++either;
    }
    return static_cast<double>(both) / static_cast<double>(either);
}

double free_m2(const GridMap& map) {
    std::size_t count = 0;
    for (const CellState state : map.states.values) count += state == CellState::free ? 1U : 0U;
    return static_cast<double>(count) * map.resolution_m * map.resolution_m;
}

TEST(SlowRealLogs, IntelAgreesWithItsTruth) {
    const std::filesystem::path log = shared("data/logs/intel.log");
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "no data/logs/intel.log";
    const Folder folder;
    const Outcome outcome = run_quadcut({"map", log.string(), "-o", folder / "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const GridMap map = io::read_map(folder / "out/map.yaml").map;
    const GridMap truth = io::read_map(shared("data/logs/intel.gt.yaml")).map;
    const double iou = free_iou(truth, map);
    std::printf("intel.log: free space IoU %.3f, %.0f m2 of %.0f m2\n", iou, free_m2(map),
                free_m2(truth));
    EXPECT_GE(iou, 0.9);
    // What is compared is most of the truth.
    EXPECT_GE(free_m2(map), 0.9 * free_m2(truth));
}

TEST(SlowRealLogs, AWholeMapHasTheRoomsOfAWindowThatHoldsIt) {
    const std::filesystem::path log = shared("data/logs/aces_dense.log.gz");
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "no data/logs/aces_dense.log.gz";
    const Folder folder;
    const Outcome outcome = run_quadcut({"map", log.string(), "-o", folder / "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const GridMap map = io::read_map(folder / "out/map.yaml").map;
    const Raster<std::uint8_t> kept = inside(map, {}, 2.0, {});
    const auto rooms_of = [&](const auto& add_beyond, Hierarchy* hierarchy) {
        StageClock clock;
        return cut_into_rooms({kept, map.states, map.resolution_m, add_beyond}, {}, clock, {2},
                              hierarchy)
            .rooms.values;
    };
    // A window keeps its pieces beside its rooms, a whole map only where a hierarchy is asked for.
    Hierarchy hierarchy;
    const auto whole = rooms_of(nullptr, nullptr);
    EXPECT_EQ(whole, rooms_of([](const auto&, auto&) {}, nullptr));
    EXPECT_EQ(whole, rooms_of(nullptr, &hierarchy));
}

TEST(SlowRealLogs, EachLogIsMappedAndCut) {
    const std::filesystem::path logs = shared("data/logs");
    if (!std::filesystem::exists(logs)) GTEST_SKIP() << "no data/logs";
    const Folder folder;
    for (const std::string name : {"intel.log", "mit_csail.log", "aces.log"}) {
        const std::string out = folder / name;
        const Outcome outcome = run_quadcut({"segment", (logs / name).string(), "-o", out});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const auto parts = num_parts_by_label(read_labels(out + "/rooms.png"));
        EXPECT_GE(parts.size(), 5U) << name;
        for (const auto& [label, count] : parts) EXPECT_EQ(count, 1) << name << ": " << label;
        const GridMap map = io::read_map(out + "/map.yaml").map;
        EXPECT_GE(free_m2(map), 200.0) << name;
    }
}

TEST(SlowRealLogs, CompressedAndOtherMessagesAreRead) {
    const std::filesystem::path logs = shared("data/logs");
    if (!std::filesystem::exists(logs)) GTEST_SKIP() << "no data/logs";
    const Folder folder;
    for (const std::string name : {"mit_csail_dense.log.gz", "intel_robotlaser.log.gz"}) {
        const std::string out = folder / name;
        const Outcome outcome = run_quadcut({"map", (logs / name).string(), "-o", out});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_GE(free_m2(io::read_map(out + "/map.yaml").map), 200.0) << name;
    }
}

}  // namespace
}  // namespace quadcut::test
