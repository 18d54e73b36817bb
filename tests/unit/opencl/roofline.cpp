// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/roofline.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(Roofline, TheSlowestOfWhatOverlapsDecides) {
    const MachineRates machine{1e9, 1e10, 1e8, 0.001, 0.5};
    // Start 0.5 s, two launches, 0.1 s up; then operations 2 s, memory 1 s, down 0.3 s.
    EXPECT_DOUBLE_EQ(stage_s({2e9, 1e10, 1e7, 3e7, 2.0}, machine), 0.5 + 0.002 + 0.1 + 2.0);
    EXPECT_DOUBLE_EQ(stage_s({2e9, 3e10, 1e7, 3e7, 2.0}, machine), 0.5 + 0.002 + 0.1 + 3.0);
    EXPECT_DOUBLE_EQ(stage_s({2e9, 1e10, 1e7, 4e8, 2.0}, machine), 0.5 + 0.002 + 0.1 + 4.0);
}

TEST(Roofline, SharedMemoryHasNoLink) {
    const MachineRates machine{1e9, 1e10, std::numeric_limits<double>::infinity(), 0.0, 0.0};
    EXPECT_DOUBLE_EQ(stage_s({1e9, 0.0, 1e12, 1e12, 4.0}, machine), 1.0);
}

/// Whether a map of so many free leaves has its edges sooner on a machine than on two threads.
bool gains(std::size_t num_nodes, const MachineRates& machine) {
    const EdgeStageSize size{num_nodes, 2 * num_nodes, 5 * num_nodes, num_nodes, num_nodes / 4};
    return stage_s(edge_stage(size), machine) < edge_stage_on_cpu_s(5 * num_nodes, 2);
}

TEST(Roofline, EdgesOfAFloorAreThereBeforeADeviceHasStarted) {
    EXPECT_FALSE(gains(50'000, discrete_gpu()));
    EXPECT_FALSE(gains(50'000, integrated_gpu()));
    MachineRates started = discrete_gpu();
    started.start_s = 0.0;
    EXPECT_TRUE(gains(50'000, started));
}

TEST(Roofline, EdgesOfManyBuildingsPayForTheStart) {
    EXPECT_FALSE(gains(1'000'000, discrete_gpu()));
    EXPECT_TRUE(gains(10'000'000, discrete_gpu()));
}

TEST(Roofline, OneProductNeverPaysForItsWayUp) {
    MachineRates machine = discrete_gpu();
    machine.start_s = 0.0;
    for (const std::size_t num_rows : {1'000U, 100'000U, 10'000'000U}) {
        EXPECT_GT(stage_s(block_product(num_rows, 10 * num_rows, 1), machine),
                  block_product_on_cpu_s(10 * num_rows, 1, 2));
    }
}

}  // namespace
}  // namespace quadcut
