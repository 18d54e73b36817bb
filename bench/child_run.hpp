// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace quadcut {

/// What a process took.
struct ChildRun {
    double wall_ms = 0.0;
    double cpu_ms = 0.0;
    double peak_bytes = 0.0;
};

inline double in_ms(const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

/// Runs a program with its standard output thrown away.
inline ChildRun run_child(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);

    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int error =
        posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error(words[0] + " cannot be started");
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child || status != 0) {
        throw std::runtime_error(words[0] + " failed");
    }
    const auto end = std::chrono::steady_clock::now();
    constexpr double kKibibyte = 1024.0;
    return {std::chrono::duration<double, std::milli>(end - start).count(),
            in_ms(usage.ru_utime) + in_ms(usage.ru_stime),
            kKibibyte * static_cast<double>(usage.ru_maxrss)};
}

}  // namespace quadcut
