// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quadcut/base/run_options.hpp"

namespace quadcut {

/// Wall time, milliseconds.
[[nodiscard]] inline double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Wall time by stage. A stage lasts until the next one begins; a stage that is entered again adds
/// to its time.
class StageClock {
public:
    explicit StageClock(StageCallback on_stage = {}) : on_stage_(std::move(on_stage)) {}

    void begin(std::string_view stage) {
        end();
        current_ = stage;
        if (on_stage_) on_stage_(stage);
    }
    /// Ends the last stage. By stage, in order of first use, milliseconds.
    std::vector<std::pair<std::string, double>> finish() {
        end();
        current_.clear();
        return stages_ms_;
    }

private:
    void end() {
        const double ms = ms_since(since_);
        since_ = std::chrono::steady_clock::now();
        if (current_.empty()) return;
        for (auto& [stage, total_ms] : stages_ms_) {
            if (stage != current_) continue;
            total_ms += ms;
            return;
        }
        stages_ms_.emplace_back(current_, ms);
    }

    StageCallback on_stage_;
    std::string current_;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
    std::vector<std::pair<std::string, double>> stages_ms_;
};

}  // namespace quadcut
