// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "quadcut/base/parallel.hpp"

// What benchmarks have in common that measure the same thing case by case.
namespace quadcut {

/// What case i comes to, for each, in order. Two cases at a time: `work` keeps to its own thread.
template <typename Result>
std::vector<Result> run_cases(std::size_t count, const std::function<Result(std::size_t)>& work) {
    std::vector<Result> results(count);
    parallel_for(Executor{2}, count, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) results[i] = work(i);
    });
    return results;
}

/// Says on stderr that one more of `count` cases is done; from any thread.
class Progress {
public:
    explicit Progress(std::size_t count) : count_(count) {}
    void note(const std::string& text) {
        const std::lock_guard lock(mutex_);
        std::fprintf(stderr, "[%zu/%zu] %s\n", ++num_done_, count_, text.c_str());
    }

private:
    std::mutex mutex_;
    std::size_t count_;
    std::size_t num_done_ = 0;
};

/// The value at a quantile of values in ascending order, 0..1; 0 when there are none.
inline double quantile(const std::vector<double>& ascending, double q) {
    if (ascending.empty()) return 0.0;
    const double place = q * static_cast<double>(ascending.size() - 1);
    return ascending[static_cast<std::size_t>(std::lround(place))];
}

/// Percent of a whole; 0 of nothing.
inline double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Takes -o and the file after it out of the words; empty when there is none.
inline std::string take_output_path(std::vector<std::string>& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] != "-o") continue;
        std::string output = words[i + 1];
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                    words.begin() + static_cast<std::ptrdiff_t>(i + 2));
        return output;
    }
    return {};
}

/// The file after -o, empty when none is given.
inline std::string output_path(int argc, char** argv) {
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::string(argv[i]) == "-o") return argv[i + 1];
    }
    return {};
}

}  // namespace quadcut
