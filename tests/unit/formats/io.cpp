// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/io.hpp"

#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "io/file.hpp"
#include "quadcut/base/error.hpp"
#include "tests/unit/io/floor_drawing.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

using io::test::ScratchFolder;

TEST(FilesOfStrangers, AMapComesBackAsItWasWritten) {
    const ScratchFolder folder;
    GridMap map = io::test::drawn_floor({"#####", "#aab#", "#####"}, 4).map;
    map.map_from_image = {-1.5, 2.25, 0.0};
    write_map(folder.path(), map);
    const MapInFile file = read_map(folder.path() / "map.yaml");
    EXPECT_EQ(map.states.values, file.map.states.values);
    EXPECT_EQ(map.map_from_image, file.map.map_from_image);
    EXPECT_EQ(file.warnings, std::vector<std::string>());
}

TEST(FilesOfStrangers, RoomsAreTheFilesOfTheProgram) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = io::test::drawn_floor({"#####", "#aab#", "#####"}, 8);
    write_rooms(folder.path(), floor.map, floor.segmentation);
    EXPECT_EQ(folder.names().size(),
              formats::files_of(formats::formats_of({formats::Part::rooms, formats::Part::report}))
                  .size());
}

TEST(FilesOfStrangers, ScansComeOneByOneInTheirOrder) {
    const ScratchFolder folder;
    const std::string log = (folder.path() / "robot.log").string();
    io::write_file_atomically(log,
                              "FLASER 3 1.0 1.1 1.2 0 0 0 0 0 0 1.5 host 1.5\n"
                              "FLASER 3 2.0 2.1 2.2 1 0 0 1 0 0 2.5 host 2.5\n");
    std::vector<float> first_ranges_m;
    const auto warnings =
        read_scans(log, [&](const Scan& scan) { first_ranges_m.push_back(scan.ranges_m.at(0)); });
    EXPECT_EQ(first_ranges_m, (std::vector<float>{1.0F, 2.0F}));
    EXPECT_EQ(warnings, std::vector<std::string>());
    EXPECT_THROW(read_scans(folder.path() / "none.log", [](const Scan&) {}), InputError);
}

}  // namespace
}  // namespace quadcut
