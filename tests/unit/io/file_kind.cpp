// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_kind.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/unit/io/gzip.hpp"

namespace quadcut::io {
namespace {

using namespace std::string_literals;

using test::gzip;

FileKind kind(const std::string& bytes, const std::string& name = "x") {
    return find_file_nature(bytes, name).kind;
}

TEST(FileKind, ContentComesBeforeTheName) {
    EXPECT_EQ(kind("P5\n1 1\n255\n", "robot.log"), FileKind::image);
    EXPECT_EQ(kind("# a robot\nFLASER 1 2\n", "map.png"), FileKind::laser_log);
    EXPECT_EQ(kind("# saved\nimage: a.pgm\n", "map.txt"), FileKind::map_yaml);
    EXPECT_EQ(kind("\xEF\xBB\xBFimage: a.pgm\r\n"), FileKind::map_yaml);
    EXPECT_EQ(kind("VERTEX_SE2 0 1 2 0.5\n", "a.log"), FileKind::poses);
    EXPECT_EQ(kind("#ROSBAG V2.0\n", "robot.log"), FileKind::unknown);
}

TEST(FileKind, TheNameDecidesWhereTheContentDoesNot) {
    EXPECT_EQ(kind("", "map.yaml"), FileKind::map_yaml);
    EXPECT_EQ(kind("hello", "MAP.PGM"), FileKind::image);
    EXPECT_EQ(kind("hello", "a.log"), FileKind::laser_log);
    EXPECT_EQ(kind("1 0 0 0 0 0 0 1\n", "a.tum"), FileKind::poses);
    EXPECT_EQ(kind("hello"), FileKind::unknown);
}

TEST(FileKind, LooksIntoGzip) {
    EXPECT_EQ(kind(gzip("P5\n1 1\n255\n"), "a.log.gz"), FileKind::image);
    EXPECT_EQ(kind(gzip("FLASER 1 2\n"), "a.gz"), FileKind::laser_log);
    EXPECT_EQ(kind(gzip("hello"), "map.pgm.gz"), FileKind::image);
    EXPECT_EQ(kind(gzip("hello"), "a.gz"), FileKind::laser_log);
    EXPECT_EQ(find_file_nature(gzip("#ROSBAG V2.0\n"), "a.gz").what, "a ROS 1 bag");
}

TEST(FileKind, ADatabaseIsToldByItsMarkAndItsName) {
    const std::string database = "SQLite format 3\0"s + std::string(84, '\0');
    EXPECT_EQ(find_file_nature(database, "a.db3").what, "a ROS 2 bag");
    EXPECT_EQ(find_file_nature(database, "a").what, "an SQLite database");
    std::string project = database;
    project.replace(68, 4, "QCUT");
    EXPECT_EQ(find_file_nature(project, "a.db3").what, "a project of quadcut");
}

TEST(FileKind, ARefusalSaysWhatIsKnown) {
    EXPECT_EQ(
        describe_refusal("%PDF", "a.yaml", "a map"),
        "a.yaml: is a PDF, expected a map; export it as a PNG, black where there are walls and "
        "white where the floor is free");
    // A name alone promises nothing.
    EXPECT_EQ(describe_refusal("hello", "a.png", "an image"),
              "a.png: is of no kind that is known, expected an image");
    EXPECT_EQ(describe_refusal("", "a.png", "an image"),
              "a.png: the file is empty, expected an image");
}

}  // namespace
}  // namespace quadcut::io
