// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "bench/shared_folder.hpp"
#include "io/carmen.hpp"
#include "quadcut/map/integrate.hpp"

// Logs with every scan, whose poses are interpolated and at times degrees off, against the maps of
// their key frames, whose poses are good.
namespace quadcut {
namespace {

OccupancyMap map_of(const std::string& file) {
    return map_from_scans(io::read_carmen_log(shared_path("data/logs/" + file)).scans, 0.05);
}

struct Agreement {
    std::size_t free_in_both = 0;
    std::size_t free_in_either = 0;  // where both are known
    std::size_t free_in_key_frames = 0;
    std::size_t free_in_dense = 0;

    [[nodiscard]] double iou() const {
        return static_cast<double>(free_in_both) / static_cast<double>(free_in_either);
    }
    [[nodiscard]] double growth() const {
        return static_cast<double>(free_in_dense) / static_cast<double>(free_in_key_frames);
    }
};

Agreement compare(const OccupancyMap& key_frames, const OccupancyMap& dense) {
    Agreement agreement;
    const Raster<CellState> states = key_frames.to_raster();
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const CellState other = dense.state(states.cell(i));
        const bool free = states.values[i] == CellState::free;
        const bool other_free = other == CellState::free;
        agreement.free_in_key_frames += free;
        if (states.values[i] != CellState::unknown && other != CellState::unknown) {
            agreement.free_in_both += free && other_free;
            agreement.free_in_either += free || other_free;
        }
    }
    for (const CellState state : dense.to_raster().values) {
        agreement.free_in_dense += state == CellState::free;
    }
    return agreement;
}

class SlowDenseLogs : public testing::TestWithParam<const char*> {};

TEST_P(SlowDenseLogs, BadPosesNeitherEatWallsNorOpenThem) {
    const std::string name = GetParam();
    const std::filesystem::path logs = shared_path("data/logs");
    if (!std::filesystem::exists(logs / (name + "_dense.log.gz"))) {
        GTEST_SKIP() << "no data/logs/" << name << "_dense.log.gz";
    }
    const Agreement agreement = compare(map_of(name + ".log"), map_of(name + "_dense.log.gz"));
    std::printf("%s: IoU with the key frames' map %.3f, free space x %.2f\n", name.c_str(),
                agreement.iou(), agreement.growth());
    EXPECT_GT(agreement.iou(), 0.95);
    EXPECT_LT(agreement.growth(), 1.25);
    EXPECT_GT(agreement.growth(), 0.9);
}

INSTANTIATE_TEST_SUITE_P(Sites, SlowDenseLogs, testing::Values("intel", "aces", "mit_csail"));

}  // namespace
}  // namespace quadcut
