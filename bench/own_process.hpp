// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include "bench/result_file.hpp"

namespace quadcut {

/// Calls `work` in a process of its own and gives what it returns: memory that one case leaves
/// behind, and its peak, are not those of the next. Throws std::runtime_error when it fails there.
/// @pre no thread has been started in this process.
inline Json in_own_process(const std::function<Json()>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start a process");
    if (child == 0) {
        close(ends[0]);
        std::string text;
        try {
            text = work().dump();
        } catch (const std::exception& error) {
            text = Json{{"error", error.what()}}.dump();
        }
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t count = write(ends[1], text.data() + done, text.size() - done);
            if (count <= 0) break;
            done += static_cast<std::size_t>(count);
        }
        // Nothing of the parent's is to be ended twice.
        _exit(0);
    }
    close(ends[1]);
    std::string text;
    char part[4096];
    for (ssize_t count = 0; (count = read(ends[0], part, sizeof part)) > 0;) {
        text.append(part, static_cast<std::size_t>(count));
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    Json result = Json::parse(text, nullptr, false);
    if (result.is_discarded()) throw std::runtime_error("the process of a case was ended");
    if (result.contains("error")) throw std::runtime_error(result["error"].get<std::string>());
    return result;
}

/// What /proc/self/status says in kB under a key such as VmRSS, in MiB.
inline double own_mib(const char* key) {
    return std::strtod(result_file::value_in("/proc/self/status", key, ':').c_str(), nullptr) /
           1024.0;
}

/// From now on VmHWM is the peak since now.
inline void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace quadcut
