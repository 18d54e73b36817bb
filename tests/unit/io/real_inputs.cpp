// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "bench/shared_folder.hpp"
#include "io/carmen.hpp"
#include "io/map_server.hpp"

// The maps and logs of ../shared/data, where they are present.

namespace quadcut::io {
namespace {

const std::filesystem::path kData = shared_path("data");

std::size_t count(const GridMap& map, CellState state) {
    return static_cast<std::size_t>(
        std::count(map.states.values.begin(), map.states.values.end(), state));
}

struct ExpectedLog {
    const char* name;
    std::size_t num_scans;
    std::size_t num_beams;
    std::uint64_t num_backward_times;
    double no_return_m;  ///< what the log gives for it
    double farthest_m;   ///< no true reading is beyond
};

class RealLog : public testing::TestWithParam<ExpectedLog> {};

TEST_P(RealLog, IsReadWithItsNoReturnValue) {
    const ExpectedLog& expected = GetParam();
    const auto path = kData / "logs" / expected.name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const LogFile log = read_carmen_log(path);
    EXPECT_EQ(log.scans.size(), expected.num_scans);
    EXPECT_EQ(log.counts.backward_times.count, expected.num_backward_times);
    EXPECT_EQ(log.warnings.size(), expected.num_backward_times > 0 ? 1U : 0U);
    for (const Scan& scan : log.scans) {
        ASSERT_EQ(scan.ranges_m.size(), expected.num_beams);
        ASSERT_LE(scan.max_range_m, expected.no_return_m);
        for (const float range : scan.ranges_m) {
            const auto range_m = static_cast<double>(range);
            ASSERT_TRUE(range_m >= scan.max_range_m || range_m <= expected.farthest_m) << range_m;
        }
        ASSERT_NEAR(scan.first_angle_rad, -1.5708, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Logs, RealLog,
    testing::Values(ExpectedLog{"intel.log", 910, 180, 4, 81.83, 30},
                    ExpectedLog{"intel_dense.log.gz", 13'631, 180, 631, 81.83, 30},
                    ExpectedLog{"intel_robotlaser.log.gz", 2'672, 180, 97, 50, 30},
                    ExpectedLog{"mit_csail.log", 406, 361, 0, 81.91, 43},
                    ExpectedLog{"mit_csail_dense.log.gz", 1'988, 361, 0, 81.91, 43},
                    ExpectedLog{"aces.log", 440, 180, 0, 50, 49.5},
                    ExpectedLog{"aces_dense.log.gz", 7'374, 180, 0, 50, 49.5},
                    ExpectedLog{"mit_killian_dense.log.gz", 17'480, 180, 0, 51.05, 50.5}));

class RealMaps : public testing::TestWithParam<const char*> {};

TEST_P(RealMaps, AreAllRead) {
    const auto folder = kData / GetParam();
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    int num_maps = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const bool is_large = entry.path().filename() == "rangelibc_gigantic_map.png";
        if (entry.path().extension() == ".gz" || entry.path().extension() == ".log") continue;
        if (entry.path().string().find("rooms.png") != std::string::npos || is_large) continue;
        const MapFile file = read_map(entry.path());
        EXPECT_GT(count(file.map, CellState::free), 1000U) << entry.path();
        EXPECT_GT(count(file.map, CellState::occupied), 500U) << entry.path();
        ++num_maps;
    }
    EXPECT_GT(num_maps, 0);
}

INSTANTIATE_TEST_SUITE_P(Folders, RealMaps, testing::Values("maps", "rooms", "logs"));

TEST(RealMap, UnknownIsNotFreeWhateverTheThresholdSays) {
    const auto path = kData / "maps" / "nav2_depot.yaml";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const MapFile file = read_map(path);
    EXPECT_EQ(count(file.map, CellState::unknown), 8894U);
    ASSERT_EQ(file.warnings.size(), 1U);
    EXPECT_NE(file.warnings[0].find("grey 205"), std::string::npos);
    EXPECT_NE(file.warnings[0].find("free_thresh 0.25"), std::string::npos);
}

TEST(RealMaps, AllButThoseOfShiftedGreysAreReadByTheirKeys) {
    int num_maps = 0;
    for (const char* folder : {"rooms", "real", "real/growing", "logs"}) {
        if (!std::filesystem::exists(kData / folder)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(kData / folder)) {
            if (entry.path().extension() != ".yaml") continue;
            // Its unknown is 206, free at 0.196.
            const bool is_shifted = entry.path().stem() == "willow_full_stage";
            const MapFile file = read_map(entry.path());
            EXPECT_EQ(file.warnings.size(), is_shifted ? 1U : 0U) << entry.path();
            ++num_maps;
        }
    }
    if (num_maps == 0) GTEST_SKIP() << kData << " has no maps";
}

TEST(RealMap, SlowTheGiganticOneNeedsNoMoreThanItsCells) {
    const auto path = kData / "maps" / "rangelibc_gigantic_map.png";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const MapFile file = read_map(path, {.resolution_m = 0.05});
    EXPECT_EQ(file.map.states.width, 10'976);
    EXPECT_EQ(file.map.states.height, 10'976);
    EXPECT_GT(count(file.map, CellState::free), 30'000'000U);
    EXPECT_GT(count(file.map, CellState::unknown), 80'000'000U);
}

}  // namespace
}  // namespace quadcut::io
