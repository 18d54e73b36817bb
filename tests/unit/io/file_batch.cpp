// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_batch.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/authorship.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

/// A file of ours.
const std::string kOwn(kAuthorComment);

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
    scratch.write("a.txt", kOwn);
    {
        FileBatch batch(scratch.path());
        batch.add("a.txt", "new");
        batch.add("folder/deeper/b.txt", "new");
    }
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a.txt"});
    EXPECT_EQ(read_file(scratch.path() / "a.txt"), kOwn);
}

TEST(FileBatch, TakesAwayWhatAKilledProgramLeft) {
    const ScratchFolder scratch;
    // There is no process of so high a number; one that there is may be writing still.
    const std::string killed = ".new999999999";
    const std::string alive = ".new" + std::to_string(::getppid());
    for (const std::string& end : {killed, killed + ".tmp999999999_0", killed + "x", alive}) {
        scratch.write("a.txt" + end, kOwn);
    }
    scratch.write("a.txt.new999999998", "a file of somebody who calls his files so");
    scratch.write("a.txt" + killed + ".tmp1_0", "another process");
    scratch.write("b.txt" + killed, kOwn);
    scratch.write("a.txt.newest", "no number");
    FileBatch batch(scratch.path());
    batch.add("a.txt", "new");
    batch.commit();
    std::vector<std::string> names = scratch.names();
    std::sort(names.begin(), names.end());
    std::vector<std::string> expected{"a.txt" + alive,
                                      "a.txt",
                                      "a.txt" + killed + "x",
                                      "a.txt.new999999998",
                                      "a.txt" + killed + ".tmp1_0",
                                      "a.txt.newest",
                                      "b.txt" + killed};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(names, expected);
}

TEST(FileBatch, NamesAFolderThatIsAFile) {
    const ScratchFolder scratch;
    const auto file = scratch.write("file", "x");
    const std::string message = error_of([&] { FileBatch(file).add("a.txt", "new"); });
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    const std::string below = error_of([&] { FileBatch(file / "below").add("a.txt", "new"); });
    EXPECT_EQ(below.find(file.string() + ": is no folder"), 0U) << below;
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

TEST(FileBatch, TakesThePlaceOfOwnFilesOnly) {
    const ScratchFolder scratch;
    scratch.write("own.yaml", "image: x\nformat_version: 1\n");
    const auto foreign = scratch.write("foreign.yaml", "image: x\n");
    const std::vector<std::string> names{"own.yaml", "new.yaml", "foreign.yaml"};
    FileBatch batch(scratch.path());
    batch.require_free({names.data(), 2});
    batch.add("own.yaml", "new");
    for (const std::string& message : {error_of([&] { batch.require_free(names); }),
                                       error_of([&] { batch.add("foreign.yaml", "new"); })}) {
        EXPECT_EQ(message.find(foreign.string() + ": "), 0U) << message;
        EXPECT_NE(message.find("--force"), std::string::npos) << message;
    }
    FileBatch forced(scratch.path(), {{}, ForeignFiles::replace});
    forced.add("foreign.yaml", "new");
    forced.commit();
    EXPECT_EQ(read_file(foreign), "new");
}

TEST(FileBatch, NeverTakesThePlaceOfAnInputWhateverItIsCalled) {
    const ScratchFolder scratch;
    const auto input = scratch.write("input", kOwn);
    std::filesystem::create_symlink("input", scratch.path() / "link");
    std::filesystem::create_hard_link(input, scratch.path() / "twin");
    std::filesystem::create_directory_symlink(".", scratch.path() / "here");
    const FileBatch batch(scratch.path(),
                          {{scratch.path() / "gone", input}, ForeignFiles::replace});
    for (const std::string name : {"input", "link", "twin", "here/input", "./input"}) {
        const std::string message = error_of([&] { batch.require_free({&name, 1}); });
        EXPECT_EQ(message.find((scratch.path() / name).string() + ": is read"), 0U)
            << name << ": " << message;
    }
}

TEST(FileBatch, PutsBackWhatItHasReplacedWhenOneCannotBe) {
    const ScratchFolder scratch;
    scratch.write("a.txt", kOwn);
    FileBatch batch(scratch.path());
    batch.add("a.txt", "new");
    batch.add("b.txt", "new");
    batch.add("c.txt", "new");
    for (const std::string& name : scratch.names()) {
        if (name.rfind("c.txt", 0) == 0) std::filesystem::remove(scratch.path() / name);
    }
    const std::string message = error_of([&] { batch.commit(); });
    EXPECT_EQ(message.find((scratch.path() / "c.txt").string() + ": "), 0U) << message;
    EXPECT_EQ(read_file(scratch.path() / "a.txt"), kOwn);
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "b.txt"));
}

}  // namespace
}  // namespace quadcut::io
