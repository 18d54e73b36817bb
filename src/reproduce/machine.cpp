// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/machine.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace quadcut::reproduce {
namespace {

std::string cpu_model() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown";
#endif
}

}  // namespace

Machine this_machine() {
    double load = 0.0;
    if (::getloadavg(&load, 1) != 1) load = 0.0;
    return {cpu_model(), std::max(1U, std::thread::hardware_concurrency()), compiler_name(), load};
}

}  // namespace quadcut::reproduce
