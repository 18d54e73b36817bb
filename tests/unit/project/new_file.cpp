// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/new_file.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::project {
namespace {

using io::test::error_of;
using io::test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(NewFile, TakesAwayWhatAKilledProgramLeft) {
    const ScratchFolder folder;
    for (const char* const end : {"-wal", "-shm", "-journal"})
        folder.write(std::string("p") + end, "x");
    make_database_file(folder.path() / "p", "bytes");
    EXPECT_EQ(io::read_file(folder.path() / "p"), "bytes");
    EXPECT_THAT(folder.names(), ElementsAre("p"));
}

TEST(NewFile, IsNotMadeWhereOneIs) {
    const ScratchFolder folder;
    const auto path = folder.write("p", "first");
    folder.write("p-wal", "of the first");
    EXPECT_THAT(error_of([&] { make_database_file(path, "second"); }),
                HasSubstr("p: is in use: another program is making it"));
    EXPECT_EQ(io::read_file(path), "first");
    EXPECT_EQ(io::read_file(folder.path() / "p-wal"), "of the first");
}

TEST(NewFile, ErrorsNameTheFileThatWasGiven) {
    const ScratchFolder folder;
    const auto in_nothing = folder.path() / "none" / "p";
    EXPECT_THAT(error_of([&] { make_database_file(in_nothing, "x"); }),
                HasSubstr(in_nothing.string() + ": cannot be written"));
    std::filesystem::create_symlink("nowhere", folder.path() / "link");
    EXPECT_THAT(error_of([&] { make_database_file(folder.path() / "link", "x"); }),
                HasSubstr((folder.path() / "link").string() + ": cannot be written"));
    EXPECT_THAT(folder.names(), ElementsAre("link"));
}

}  // namespace
}  // namespace quadcut::project
