// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/found_instead.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::ScratchFolder;

TEST(FoundInstead, NothingOrAFile) {
    const ScratchFolder folder;
    EXPECT_EQ(found_instead_of_result(folder.path() / "none"), "no such folder");
    EXPECT_EQ(found_instead_of_result(folder.write("map.yaml", "image: map.pgm\n")), "a file");
    const std::string database = "SQLite format 3" + std::string(53, '\0');
    EXPECT_EQ(found_instead_of_result(folder.write("bag.db3", database + "abcd")), "a file");
    EXPECT_EQ(found_instead_of_result(folder.write("home.quadcut", database + "QCUT")),
              "a project of quadcut");
    EXPECT_EQ(found_instead_of_result("/dev/zero"), "something that is no folder");
}

TEST(FoundInstead, AFileOfAResultNamesItsFolder) {
    const ScratchFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::filesystem::path yaml = folder.write("out/rooms.yaml", "");
    EXPECT_FALSE(has_result(folder.path()));
    EXPECT_TRUE(has_result(out));
    EXPECT_EQ(found_instead_of_result(yaml), "a file: did you mean '" + out + "'?");
}

TEST(FoundInstead, AFolderSaysWhatIsInIt) {
    const ScratchFolder folder;
    folder.write("b.pgm", "");
    folder.write("a.yaml", "");
    EXPECT_EQ(found_instead_of_result(folder.path()), "no rooms.yaml in it (a.yaml, b.pgm)");
    folder.write("z/rooms.yaml", "");
    folder.write("y", "");
    EXPECT_EQ(found_instead_of_result(folder.path()),
              "no rooms.yaml in it (a.yaml, b.pgm, y and 1 more): did you mean '" +
                  (folder.path() / "z").string() + "'?");
}

}  // namespace
}  // namespace quadcut::io
