// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/progress.hpp"

#include <algorithm>
#include <iostream>

#include <unistd.h>

namespace quadcut {
namespace {

constexpr std::size_t kStageWidth = 12;
constexpr std::size_t kBarWidth = 40;
constexpr std::chrono::milliseconds kRedrawAfter{100};

}  // namespace

ProgressStyle progress_style(ProgressStyle wanted) {
    return ::isatty(STDERR_FILENO) == 1 ? wanted : ProgressStyle::none;
}

void Progress::begin(std::string_view stage) {
    if (style_ == ProgressStyle::none) return;
    stage_ = stage;
    stage_.resize(std::max(stage_.size(), kStageWidth), ' ');
    percent_ = 0;
    const bool is_new = stages_.insert(stage_).second;
    if (is_new || std::chrono::steady_clock::now() - drawn_at_ > kRedrawAfter) draw(stage_ + "...");
}

void Progress::update(std::size_t num_done, std::size_t num_all) {
    update(num_done, num_all, [] { return std::string(); });
}

void Progress::update(std::size_t num_done, std::size_t num_all,
                      const std::function<std::string()>& text) {
    if (style_ == ProgressStyle::none || num_all == 0) return;
    const double share = static_cast<double>(num_done) / static_cast<double>(num_all);
    const auto percent = static_cast<std::size_t>(100.0 * std::clamp(share, 0.0, 1.0));
    if (percent == percent_) return;
    percent_ = percent;
    const std::size_t filled = percent * kBarWidth / 100;
    draw(stage_ + "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + "] " +
         std::to_string(percent) + " %" + text());
}

void Progress::wipe() {
    if (num_drawn_ == 0) return;
    std::cerr << '\r' + std::string(num_drawn_, ' ') + '\r' << std::flush;
    num_drawn_ = 0;
}

void Progress::draw(const std::string& line) {
    // What is left of a longer line is written over.
    const std::size_t num_left = num_drawn_ > line.size() ? num_drawn_ - line.size() : 0;
    std::cerr << '\r' + line + std::string(num_left, ' ') << std::flush;
    num_drawn_ = line.size();
    drawn_at_ = std::chrono::steady_clock::now();
}

}  // namespace quadcut
