// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// cmake/commit.cmake: the commit that the program names.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// The file that names the commit of the sources in `folder`/sources, written once more.
std::string named(const Folder& folder) {
    const Outcome outcome = run_process(
        QUADCUT_CMAKE, {"-D", "SOURCE=" + folder / "sources", "-D",
                        "OUTPUT=" + folder / "commit.cpp", "-P", QUADCUT_COMMIT_SCRIPT});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_bytes(folder / "commit.cpp");
}

TEST(Commit, SourcesWithoutARepositoryAreUnknown) {
    const Folder folder;
    folder.write("sources/a.cpp", "1\n");
    EXPECT_NE(named(folder).find("return \"unknown\";"), std::string::npos);
}

TEST(Commit, IsNamedAndTheFileIsWrittenOnlyWhenItIsAnother) {
    const Folder folder;
    folder.write("sources/a.cpp", "1\n");
    const auto git = [&folder](const std::string& arguments) {
        return run_process("/bin/sh", {"-c", "cd '" + folder / "sources" +
                                                 "' && git -c user.name=a -c user.email=a@b " +
                                                 arguments + " 2>&1"});
    };
    if (git("init -q").exit_code != 0) GTEST_SKIP() << "no git";
    ASSERT_EQ(git("add -A && git -c user.name=a -c user.email=a@b commit -qm one").exit_code, 0);
    std::string hash = git("rev-parse --short HEAD").out;
    hash.pop_back();
    const std::string clean = named(folder);
    EXPECT_NE(clean.find("return \"" + hash + "\";"), std::string::npos) << clean;

    const auto long_ago = std::filesystem::file_time_type{};
    std::filesystem::last_write_time(folder / "commit.cpp", long_ago);
    EXPECT_EQ(named(folder), clean);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "commit.cpp"), long_ago);

    folder.write("sources/docs/a.md", "documents change nothing that is measured\n");
    EXPECT_EQ(named(folder), clean);
    folder.write("sources/a.cpp", "2\n");
    EXPECT_NE(named(folder).find("return \"" + hash + "-dirty\";"), std::string::npos);
}

}  // namespace
}  // namespace quadcut::test
