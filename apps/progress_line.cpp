// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/progress_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/number_text.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kShortestBar = 10;
constexpr std::size_t kLongestBar = 40;
/// Longer is "more than a day".
constexpr double kLongest_s = 86400.0;

// The parts are as wide as they mostly are at their widest: the bar keeps its length.
constexpr std::size_t kPercentWidth = 5;
constexpr std::size_t kTimeWidth = 11;
constexpr std::size_t kRateWidth = 12;

/// Two spaces before a part, and after it what it is shorter than it may be.
std::string part(std::string text, std::size_t width) {
    if (!text.empty() || width > 0) text.resize(std::max(text.size(), width), ' ');
    return text.empty() ? "" : "  " + text;
}

std::string percent_text(double share) {
    const auto percent = static_cast<int>(100.0 * share);
    std::string text = std::to_string(percent) + " %";
    return std::string(kPercentWidth - std::min(kPercentWidth, text.size()), ' ') + text;
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
    if (!(seconds < kLongest_s)) return "more than a day";
    const double whole_s = std::max(1.0, std::ceil(seconds));
    if (whole_s < 60.0) return io::rounded(whole_s, 0) + " s";
    const double whole_min = std::ceil(seconds / 60.0);
    if (whole_min < 60.0) return io::rounded(whole_min, 0) + " min";
    return io::rounded(std::ceil(seconds / 3600.0), 0) + " h";
}

std::string progress_line(const ProgressState& state, std::size_t width) {
    if (!state.share) return without_end(std::string(state.stage) + " ...", width);
    const double share = std::clamp(*state.share, 0.0, 1.0);
    const std::string stage(state.stage);
    const std::string percent = part(percent_text(share), kPercentWidth);
    const std::string time =
        part(state.left_s ? in_words(*state.left_s) + " left" : "", kTimeWidth);
    std::string rate;
    if (!state.unit.empty()) {
        const std::string number =
            state.rate ? io::rounded(*state.rate, *state.rate < 10.0 ? 1 : 0) : "";
        rate =
            part(number.empty() ? "" : number + " " + std::string(state.unit) + "/s", kRateWidth);
    }
    const std::string more = part(std::string(state.more), 0);

    // From all there is to the least: what fits first is shown.
    const std::array<std::string, 4> tails{percent + time + rate + more, percent + time + rate,
                                           percent + time, percent};
    for (const std::string& tail : {tails[0], tails[1]}) {
        const std::size_t rest = stage.size() + tail.size() + bar_text(share, 0).size();
        if (rest + kShortestBar > width) continue;
        const std::size_t length = std::min(width - rest, kLongestBar);
        return without_end(stage + bar_text(share, length) + tail, width);
    }
    for (const std::string& tail : tails) {
        if (&tail == tails.data()) continue;
        if (stage.size() + tail.size() <= width) return without_end(stage + tail, width);
    }
    return without_end(stage + percent, width);
}

}  // namespace quadcut
