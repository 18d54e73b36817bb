// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/scanned_map.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/carmen.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

std::unique_ptr<ScanSource> open_log(const std::string& bytes) {
    return open_scan_source(Input({"", "x.log", "", bytes}), {});
}

TEST(ScannedMap, IsTheMapOfAllScansAndTheWayOfTheLaser) {
    std::string log;
    for (int i = 0; i < 40; ++i) {
        log += "FLASER 5 2 2 2 2 2 " + std::to_string(i) + " 3 0 0 0 0 1 host 1\n";
    }
    const auto source = open_log(log);
    std::size_t num_done = 0;
    const ScannedMap made =
        map_scans(*source, 0.05, {}, [&](std::size_t count) { num_done = count; });
    EXPECT_EQ(num_done, 40U);
    ASSERT_EQ(made.trajectory.size(), 40U);
    EXPECT_EQ(made.trajectory[39], (Point{39.0, 3.0}));
    const OccupancyMap expected = map_from_scans(parse_carmen_log(log, "x.log").scans, 0.05);
    EXPECT_EQ(made.map.states.values, expected.to_grid().states.values);
    EXPECT_EQ(made.num_leaves, expected.num_leaves());
}

TEST(ScannedMap, SaysWhyThereIsNone) {
    const auto source = open_log("FLASER 2 0 0 1 2 0 0 0 0 1 host 1\n");
    EXPECT_EQ(test::error_of([&] { (void)map_scans(*source, 0.05, {}); }),
              "x.log: no reading says anything: expected ranges above 0 that hit something");
}

}  // namespace
}  // namespace quadcut::io
