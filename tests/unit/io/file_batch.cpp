// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_batch.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

TEST(FileBatch, ShowsItsFilesTogether) {
    const ScratchFolder scratch;
    const auto folder = scratch.path() / "new" / "deeper";
    FileBatch batch(folder);
    batch.add("a.txt", "one");
    batch.add("b.txt", "two");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    batch.commit();
    EXPECT_EQ(read_file(folder / "a.txt"), "one");
    EXPECT_EQ(read_file(folder / "b.txt"), "two");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
}

TEST(FileBatch, GivenUpLeavesEverythingAsItWas) {
    const ScratchFolder scratch;
    scratch.write("a.txt", "old");
    {
        FileBatch batch(scratch.path());
        batch.add("a.txt", "new");
        batch.add("b.txt", "new");
    }
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a.txt"});
    EXPECT_EQ(read_file(scratch.path() / "a.txt"), "old");
}

TEST(FileBatch, NamesAFolderThatIsAFile) {
    const ScratchFolder scratch;
    const auto file = scratch.write("file", "x");
    const std::string message = error_of([&] { FileBatch batch(file); });
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    const std::string below = error_of([&] { FileBatch batch(file / "below"); });
    EXPECT_NE(below.find((file / "below").string()), std::string::npos) << below;
}

TEST(FileBatch, NamesAFileThatIsAFolder) {
    const ScratchFolder scratch;
    scratch.write("a.txt/inside", "x");
    FileBatch batch(scratch.path());
    const std::string message = error_of([&] { batch.add("a.txt", "new"); });
    EXPECT_NE(message.find((scratch.path() / "a.txt").string()), std::string::npos) << message;
}

TEST(FileBatch, NamesAFileItMayNotWrite) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    const ScratchFolder scratch;
    std::filesystem::permissions(
        scratch.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    FileBatch batch(scratch.path());
    const std::string message = error_of([&] { batch.add("a.txt", "new"); });
    std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_all);
    EXPECT_EQ(message.find((scratch.path() / "a.txt").string() + ": "), 0U) << message;
    EXPECT_EQ(message.find(".new"), std::string::npos) << message;
}

TEST(FileBatch, NamesAFileThatCannotBe) {
    const ScratchFolder scratch;
    FileBatch batch(scratch.path());
    const std::string name(300, 'x');
    const std::string message = error_of([&] { batch.add(name, "new"); });
    EXPECT_EQ(message.find((scratch.path() / name).string() + ": "), 0U) << message;
    EXPECT_TRUE(scratch.names().empty());
}

}  // namespace
}  // namespace quadcut::io
