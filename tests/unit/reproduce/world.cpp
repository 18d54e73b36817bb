// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/world.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "eval/labels.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::reproduce {
namespace {

TEST(World, TheLaboratoryIsALogOfARealRobotWhoseRoomsLieOnItsMap) {
    const std::filesystem::path data = test::shared("data");
    if (!std::filesystem::exists(data / "real")) GTEST_SKIP() << "no " << data;
    const World world = laboratory(data, Size::full, 1);
    EXPECT_FALSE(world.is_simulated);
    EXPECT_FALSE(world.is_void_judged);
    EXPECT_EQ(world.scans.size(), 1988U);
    // Where a true room is, the map is free but for the furniture.
    const Raster<std::uint32_t> truth = labels_at(world.truth_map, world.truth, world.map);
    std::size_t num_true = 0;
    std::size_t num_free = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (world.truth.values[i] != 0) ++num_true;
        if (truth.values[i] != 0) ++num_free;
    }
    EXPECT_GT(static_cast<double>(num_free), 0.8 * static_cast<double>(num_true));
}

TEST(World, TheRobotsOfAllWorldsStartSomewhere) {
    const World world = laboratory({}, Size::small, 1);
    EXPECT_TRUE(world.is_simulated);
    EXPECT_TRUE(world.has_truth());
    EXPECT_EQ(world.trajectory.size(), world.scans.size());
}

}  // namespace
}  // namespace quadcut::reproduce
