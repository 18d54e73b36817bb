// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "opencl/device.hpp"
#include "opencl/trial.hpp"

namespace quadcut::opencl {
namespace {

/// What is said of a process that does `work`; empty when it survives.
std::string problem_of(const std::function<void()>& work, unsigned limit_s = 60) {
    try {
        try_in_own_process(work, limit_s);
        return "";
    } catch (const DeviceError& error) {
        return error.what();
    }
}

TEST(OpenClTrial, WhatEndsWellOrThrowsIsSurvived) {
    int count = 0;
    EXPECT_EQ(problem_of([&count] { ++count; }), "");
    EXPECT_EQ(problem_of([] { throw std::runtime_error("no"); }), "");
    // It was done in another process.
    EXPECT_EQ(count, 0);
}

TEST(OpenClTrial, AProcessThatDiesIsNoted) {
    EXPECT_NE(problem_of([] { std::abort(); }).find("signal 6, Aborted"), std::string::npos);
    EXPECT_NE(problem_of([] { std::raise(SIGKILL); }).find("signal 9"), std::string::npos);
    EXPECT_NE(problem_of([] { ::_exit(0); }).find("it ended the process"), std::string::npos);
}

TEST(OpenClTrial, OneThatHangsIsEnded) {
    const auto hang = [] {
        while (true) ::pause();
    };
    EXPECT_NE(problem_of(hang, 1).find("not done after 1 s"), std::string::npos);
}

TEST(OpenClTrial, IsSurvivedWhereChildrenAreNotWaitedFor) {
    auto* const before = std::signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(problem_of([] {}), "");
    EXPECT_NE(problem_of([] { std::abort(); }), "");
    std::signal(SIGCHLD, before);
}

TEST(OpenClTrial, SaysNothing) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(problem_of([] {
                  (void)!::write(STDOUT_FILENO, "out", 3);
                  (void)!::write(STDERR_FILENO, "err", 3);
              }),
              "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace quadcut::opencl
