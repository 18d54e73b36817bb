// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "io/poses.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::formats {
namespace {

/// Rooms 1 and 2, in zones 2 and 1; 0.4 m a character.
io::test::DrawnFloor two_zones() {
    io::test::DrawnFloor floor =
        io::test::drawn_floor({"#######", "#aa#bb#", "#aaabb#", "#aa#bb#", "#######"}, 8);
    floor.segmentation.zones.count = 2;
    floor.segmentation.zones.zone_of_room = {2, 1};
    return floor;
}

std::vector<std::string> texts_of(const io::test::DrawnFloor& floor,
                                  const std::vector<Pose>& poses) {
    io::RunInfo info;
    info.poses = poses;
    const Result result(floor.map, floor.segmentation, info);
    return find_formats("g2o-submaps")[0].write(result);
}

TEST(G2o, HasAVertexAPoseAndAnEdgeFromEachToTheNext) {
    const std::vector<std::string> texts =
        texts_of(two_zones(), {{0.5, 1.0, 0.0}, {0.5, 1.25, 0.0}, {2.25, 1.25, 7.0}});
    ASSERT_EQ(texts.size(), 2U);
    EXPECT_EQ(texts[0].substr(0, texts[0].find("EDGE_SE2 1 2")),
              "VERTEX_SE2 0 0.5 1.0 0.0\n"
              "VERTEX_SE2 1 0.5 1.25 0.0\n"
              "VERTEX_SE2 2 2.25 1.25 0.7168146928204138\n"
              "EDGE_SE2 0 1 0.0 0.25 0.0 1 0 0 1 0 1\n");
    EXPECT_EQ(texts[0].substr(texts[0].size() - 13), " 1 0 0 1 0 1\n");
    EXPECT_EQ(texts[1],
              "# Written by quadcut: vertex of submaps.g2o, zone\n"
              "0 2\n1 2\n2 1\n");
}

TEST(G2o, IsReadAsPosesAgain) {
    const std::vector<Pose> poses{{0.1, -2.5, 0.3}, {1e6, 0.7, -3.1}, {1.0, 2.0, 0.0}};
    const std::vector<io::TimedPose> read =
        io::parse_poses(texts_of(two_zones(), poses)[0], "submaps.g2o");
    ASSERT_EQ(read.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_EQ(read[i].pose, poses[i]);
        EXPECT_EQ(read[i].time_s, static_cast<double>(i));
    }
}

TEST(G2o, APoseInNoRoomIsInTheZoneOfTheOneBefore) {
    // In the wall; in room 1, 2; beyond the map; in the wall.
    const std::vector<std::string> texts =
        texts_of(two_zones(),
                 {{0.1, 0.1, 0}, {0.6, 1.0, 0}, {2.2, 1.0, 0}, {-1e300, 1e300, 0}, {0.1, 0.1, 0}});
    EXPECT_EQ(texts[1].substr(texts[1].find('\n') + 1), "0 2\n1 2\n2 1\n3 1\n4 1\n");
}

TEST(G2o, NeedsZonesAndPoses) {
    io::test::DrawnFloor floor = two_zones();
    EXPECT_THROW(static_cast<void>(texts_of(floor, {})), std::logic_error);
    floor.segmentation.zones = {};
    EXPECT_THROW(static_cast<void>(texts_of(floor, {{0.6, 1.0, 0}})), std::logic_error);
}

}  // namespace
}  // namespace quadcut::formats
