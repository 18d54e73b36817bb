// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "apps/interrupted_line.hpp"

namespace quadcut {

enum class ProgressStyle : std::uint8_t { none, bar };

/// A bar if standard error is a terminal that can redraw a line, unless the user wants none.
[[nodiscard]] ProgressStyle progress_style(ProgressStyle wanted);

/// What is counted, and what else there is to say: `text()` is asked for when it is drawn.
struct ProgressText {
    /// "scans"; empty: how many a second is of no interest.
    std::string_view unit;
    std::function<std::string()> more;
};

/// One line on standard error that shows what is going on, as wide as the terminal is at that
/// moment; it is wiped when all is over. Drawn at most ten times a second, but for what begins.
class Progress {
public:
    explicit Progress(ProgressStyle style);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { wipe(); }

    /// Something begins whose length is not known. What begins again and again is not drawn
    /// each time.
    void begin(std::string_view stage);
    /// So much of the current stage is done. Cheap enough to be called a million times.
    void update(std::size_t num_done, std::size_t num_all, const ProgressText& text = {});
    /// Takes the line away, so that something else can be printed.
    void wipe();

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool is_due() const;
    void draw(const std::string& line, std::size_t width);

    /// Nothing when there is nothing to be shown.
    std::optional<InterruptedLine> line_;
    std::string stage_;
    std::set<std::string> stages_;
    /// When the stage was first updated, and how far it was then.
    std::optional<Clock::time_point> counted_from_;
    std::size_t num_before_ = 0;
    Clock::time_point drawn_at_;
    std::size_t num_drawn_ = 0;
};

}  // namespace quadcut
