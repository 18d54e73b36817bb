// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/pace.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <utility>

namespace quadcut {
namespace {

/// Who follows a robot thinks that the program hangs when it waits for longer.
constexpr double kLongestWaitS = 5.0;

/// A refinement may take so long.
constexpr double kIdleS = 0.2;

std::string text_of_span(double span_s) {
    constexpr std::array<std::pair<double, const char*>, 4> kUnits{
        {{60, "minutes"}, {3'600, "hours"}, {86'400, "days"}, {365.25 * 86'400, "years"}}};
    std::pair<double, const char*> unit{1, "seconds"};
    for (const auto& longer : kUnits) {
        if (span_s >= 2.0 * longer.first) unit = longer;
    }
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.3g %s", span_s / unit.first, unit.second);
    return text.data();
}

}  // namespace

PaceClock machine_clock() {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    PaceClock clock;
    clock.now_s = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    clock.sleep_until_s = [start](double time_s) {
        std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(
                                                  std::chrono::duration<double>(time_s)));
    };
    return clock;
}

Pace::Pace(double speed, PaceClock clock) : speed_(speed), clock_(std::move(clock)) {}

double Pace::due_after(double stamp_s) {
    const double now_s = clock_.now_s();
    if (!last_stamp_s_.has_value()) return now_s;
    const double span_s = stamp_s - *last_stamp_s_;
    // A long way back the robot's clock was set, and what follows is not to hurry for that.
    const double due_s = span_s / speed_ < -kLongestWaitS ? due_s_ : due_s_ + span_s / speed_;
    if (due_s - now_s <= kLongestWaitS) return due_s;
    ++num_holes_;
    longest_hole_s_ = std::max(longest_hole_s_, span_s);
    return now_s + kLongestWaitS;
}

void Pace::wait_for(double stamp_s, const std::function<bool()>& refine) {
    if (speed_ <= 0.0 || !std::isfinite(stamp_s)) return;
    due_s_ = due_after(stamp_s);
    last_stamp_s_ = stamp_s;
    while (clock_.now_s() + kIdleS < due_s_ && refine()) {
    }
    clock_.sleep_until_s(due_s_);
}

std::optional<std::string> Pace::warning() const {
    if (num_holes_ == 0) return std::nullopt;
    std::string text = "the time stamps have " + std::to_string(num_holes_) +
                       (num_holes_ == 1 ? " hole" : " holes") + ", the longest of " +
                       text_of_span(longest_hole_s_);
    return text + ": --speed went on after 5 s each time";
}

}  // namespace quadcut
