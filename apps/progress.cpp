// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/progress.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <sys/ioctl.h>
#include <unistd.h>

#include "apps/progress_line.hpp"

namespace quadcut {
namespace {

constexpr std::chrono::milliseconds kRedrawAfter{100};
/// What is said of speed and time before is a guess.
constexpr std::chrono::milliseconds kRateAfter{500};
constexpr std::size_t kUsualWidth = 80;

/// Columns of the terminal now: it may have been made wider or narrower.
std::size_t terminal_width() {
    struct winsize size {};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    const char* const columns = std::getenv("COLUMNS");
    const int width = columns == nullptr ? 0 : std::atoi(columns);
    return width > 0 ? static_cast<std::size_t>(width) : kUsualWidth;
}

/// The cursor goes to where a line of so many characters begins: a terminal that was made narrower
/// has broken it into several, which all are wiped.
std::string start_of_line(std::size_t num_drawn, std::size_t width) {
    const std::size_t num_above = num_drawn == 0 ? 0 : (num_drawn - 1) / width;
    return "\r" + (num_above == 0 ? "" : "\x1B[" + std::to_string(num_above) + "A\x1B[J");
}

}  // namespace

ProgressStyle progress_style(ProgressStyle wanted) {
    const char* const terminal = std::getenv("TERM");
    const bool is_dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
    return ::isatty(STDERR_FILENO) == 1 && !is_dumb ? wanted : ProgressStyle::none;
}

Progress::Progress(ProgressStyle style) {
    if (style != ProgressStyle::none) line_.emplace();
}

bool Progress::is_due() const { return Clock::now() - drawn_at_ >= kRedrawAfter; }

void Progress::begin(std::string_view stage) {
    if (!line_) return;
    stage_ = stage;
    counted_from_.reset();
    const bool is_new = stages_.insert(stage_).second;
    if (!is_new && !is_due()) return;
    const std::size_t width = terminal_width();
    draw(progress_line({stage_, {}, {}, {}, {}, {}}, width - 1), width);
}

void Progress::update(std::size_t num_done, std::size_t num_all, const ProgressText& text) {
    if (!line_ || num_all == 0) return;
    const bool is_first = !counted_from_;
    if (!is_first && !is_due()) return;
    const Clock::time_point now = Clock::now();
    if (is_first) {
        counted_from_ = now;
        num_before_ = num_done;
    }
    ProgressState state;
    state.stage = stage_;
    state.share = static_cast<double>(num_done) / static_cast<double>(num_all);
    state.unit = text.unit;
    const std::chrono::duration<double> elapsed = now - *counted_from_;
    if (elapsed >= kRateAfter && num_done > num_before_) {
        state.rate = static_cast<double>(num_done - num_before_) / elapsed.count();
        state.left_s = static_cast<double>(num_all - std::min(num_done, num_all)) / *state.rate;
    }
    const std::string more = text.more ? text.more() : "";
    state.more = more;
    // A character in the last column would have some terminals go on to the next line.
    const std::size_t width = terminal_width();
    draw(progress_line(state, width - 1), width);
}

void Progress::wipe() {
    if (num_drawn_ == 0) return;
    std::cerr << start_of_line(num_drawn_, terminal_width()) + "\x1B[K" << std::flush;
    num_drawn_ = 0;
    line_->end();
}

void Progress::draw(const std::string& line, std::size_t width) {
    // Written over, and wiped only behind its end: nothing flickers.
    std::cerr << start_of_line(num_drawn_, width) + line + "\x1B[K" << std::flush;
    line_->begin();
    num_drawn_ = line.size();
    drawn_at_ = Clock::now();
}

}  // namespace quadcut
