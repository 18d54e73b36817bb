// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/input.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

TEST(File, ReadsBackWhatWasWritten) {
    const ScratchFolder folder;
    const std::string bytes("one\0two\r\n\xff", 10);
    const auto path = folder.write("a.bin", bytes);
    EXPECT_EQ(read_file(path), bytes);
    EXPECT_EQ(read_file(folder.write("empty", "")), "");
}

TEST(File, WritingReplacesAndLeavesNothingElse) {
    const ScratchFolder folder;
    folder.write("a", "a much longer first content");
    folder.write("a", "second");
    EXPECT_EQ(read_file(folder.path() / "a"), "second");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

TEST(File, AFailedWriteKeepsTheOldContent) {
    const ScratchFolder folder;
    // A folder cannot be replaced by a file: the rename fails after everything was written.
    std::filesystem::create_directories(folder.path() / "taken" / "inside");
    const std::string error =
        error_of([&] { write_file_atomically(folder.path() / "taken", "bytes"); });
    EXPECT_EQ(error, (folder.path() / "taken").string() + ": cannot be written: Is a directory");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"taken"});
}

TEST(File, WritingIntoAMissingFolderNamesThePath) {
    EXPECT_EQ(error_of([] { write_file_atomically("/nowhere/at/all.png", "x"); }),
              "/nowhere/at/all.png: cannot be written: No such file or directory");
}

TEST(File, ReadingNamesPathAndReason) {
    const ScratchFolder folder;
    EXPECT_EQ(error_of([] { (void)read_file("/nowhere/map.yaml"); }),
              "/nowhere/map.yaml: cannot be opened: No such file or directory");
    EXPECT_EQ(error_of([&] { (void)read_file(folder.path()); }),
              folder.path().string() + ": cannot be read as a file: Is a directory");
    EXPECT_EQ(error_of([] { (void)read_file(""); }),
              "(no file name): cannot be opened: No such file or directory");
}

TEST(File, RefusesMoreThanTheLimit) {
    const ScratchFolder folder;
    const auto path = folder.write("big", "0123456789");
    EXPECT_EQ(read_file(path, 10), "0123456789");
    EXPECT_EQ(error_of([&] { (void)read_file(path, 9); }),
              path.string() + ": larger than the 9 bytes that are read at most");
}

TEST(File, RefusesDevicesBeforeTheyAreRead) {
    for (const std::string device : {"/dev/zero", "/dev/urandom", "/dev/null"}) {
        const std::string expected = device + ": is a device, expected a file or a pipe";
        EXPECT_EQ(error_of([&] { (void)read_file(device); }), expected);
        EXPECT_EQ(error_of([&] { (void)read_input(device); }), expected);
    }
}

TEST(File, ReadsFilesThatStateNoSize) {
    EXPECT_NE(read_file("/proc/self/status").find("Pid:"), std::string::npos);
}

TEST(File, HashesAsFnv1a) {
    // Published values of the 64-bit function.
    EXPECT_EQ(hash_bytes(""), 0xcbf29ce484222325ULL);
    EXPECT_EQ(hash_bytes("a"), 0xaf63dc4c8601ec8cULL);
    EXPECT_EQ(hash_bytes("foobar"), 0x85944171f73967e8ULL);
    EXPECT_EQ(hash_bytes("bar", hash_bytes("foo")), hash_bytes("foobar"));
}

}  // namespace
}  // namespace quadcut::io
