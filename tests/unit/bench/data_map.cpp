// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/data_map.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(RealMaps, OfOneBuildingAreLeftOutTogether) {
    for (const char* name : {"intel_dense", "intel_slam_a", "intel_slam_b"}) {
        EXPECT_EQ(building_of_real_map(name), "lab_intel") << name;
    }
    for (const char* name : {"fr101", "fr101_slam"}) {
        EXPECT_EQ(building_of_real_map(name), "Freiburg101_scan") << name;
    }
    for (const char* name : {"ubremen_cartesium", "cartesium_slam_b", "cartesium_17"}) {
        EXPECT_EQ(building_of_real_map(name), "ubremen_cartesium") << name;
    }
    for (const char* name : {"aces_dense", "mit_csail_dense", "willow_full_stage", "campus_1"}) {
        EXPECT_EQ(building_of_real_map(name), name);
    }
}

TEST(RealMaps, AreReadByKindAndBuilding) {
    if (!std::filesystem::exists(shared_path("data/real"))) GTEST_SKIP() << "no real maps";
    std::map<std::string, std::set<std::string>> names;
    for (const DataMap& data : read_real_maps("ubremen_cartesium")) {
        names[data.kind].insert(data.name);
        EXPECT_EQ(data.truth.width, data.map.states.width) << data.name;
        EXPECT_EQ(data.truth.height, data.map.states.height) << data.name;
        EXPECT_EQ(data.surely_free.is_free.size(), data.truth.values.size()) << data.name;
        EXPECT_GT(data.truth.num_regions, 5U) << data.name;
    }
    EXPECT_EQ(names["real"],
              (std::set<std::string>{"cartesium_slam_a", "cartesium_slam_b", "ubremen_cartesium"}));
    EXPECT_EQ(names["growing"].size(), 15U);
    EXPECT_EQ(names.size(), 2U);
}

}  // namespace
}  // namespace quadcut
