// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/progress_line.hpp"

#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kShortestBar = 10;
constexpr std::size_t kLongestBar = 40;
constexpr double kDayInSeconds = 86400.0;

// The parts are as wide as they mostly are at their widest: the bar keeps its length.
constexpr std::size_t kPercentWidth = 5;
constexpr std::size_t kTimeWidth = 11;
constexpr std::size_t kRateWidth = 12;

/// Two spaces before a part, and after it what it is shorter than it may be.
std::string part(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text.empty() ? "" : "  " + text;
}

std::string percent_text(double share) {
    const auto percent = static_cast<int>(100.0 * share);
    std::string text = std::to_string(percent) + " %";
    return std::string(kPercentWidth - std::min(kPercentWidth, text.size()), ' ') + text;
}

std::string rate_part(const ProgressState& state) {
    if (state.unit.empty()) return "";
    if (!state.rate) return part("", kRateWidth);
    std::string text = io::rounded(*state.rate, *state.rate < 10.0 ? 1 : 0);
    text.append(" ").append(state.unit).append("/s");
    return part(text, kRateWidth);
}

std::string bar_text(double share, std::size_t length) {
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(length));
    return "  [" + std::string(filled, '#') + std::string(length - filled, '.') + "]";
}

std::string without_end(std::string line, std::size_t width) {
    line.resize(std::min(line.size(), width));
    line.resize(line.find_last_not_of(' ') + 1);
    return line;
}

}  // namespace

std::string in_words(double seconds) {
    if (!(seconds < kDayInSeconds)) return "more than a day";
    const double whole_s = std::max(1.0, std::ceil(seconds));
    if (whole_s < 60.0) return io::rounded(whole_s, 0) + " s";
    const double whole_min = std::ceil(seconds / 60.0);
    if (whole_min < 60.0) return io::rounded(whole_min, 0) + " min";
    return io::rounded(std::ceil(seconds / 3600.0), 0) + " h";
}

std::string progress_line(const ProgressState& state, std::size_t width) {
    const std::string stage(state.stage);
    if (!state.share) return without_end(stage + " ...", width);
    const double share = std::clamp(*state.share, 0.0, 1.0);
    const std::string percent = part(percent_text(share), kPercentWidth);
    const std::string with_time =
        percent + part(state.left_s ? in_words(*state.left_s) + " left" : "", kTimeWidth);
    const std::string with_rate = with_time + rate_part(state);
    const std::string with_all = with_rate + part(std::string(state.more), 0);

    // From all there is to the least: what fits first is shown.
    for (const std::string& tail : {with_all, with_rate}) {
        const std::size_t others = stage.size() + bar_text(share, 0).size() + tail.size();
        if (others + kShortestBar > width) continue;
        const std::string bar = bar_text(share, std::min(width - others, kLongestBar));
        return without_end(std::string(stage).append(bar).append(tail), width);
    }
    for (const std::string& tail : {with_rate, with_time}) {
        if (stage.size() + tail.size() <= width) return without_end(stage + tail, width);
    }
    return without_end(stage + percent, width);
}

}  // namespace quadcut
