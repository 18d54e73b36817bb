// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io::test {

/// A named pipe, and a thread that writes to it.
class Pipe {
public:
    Pipe(const ScratchFolder& folder, const std::string& bytes) : path_(folder.path() / "pipe") {
        EXPECT_EQ(::mkfifo(path_.c_str(), 0600), 0);
        writer_ = std::jthread([this, bytes] {
            std::signal(SIGPIPE, SIG_IGN);
            std::ofstream(path_, std::ios::binary) << bytes;
        });
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() { std::filesystem::remove(path_); }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::jthread writer_;
};

}  // namespace quadcut::io::test
