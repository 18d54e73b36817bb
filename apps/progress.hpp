// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace quadcut {

enum class ProgressStyle : std::uint8_t { none, bar };

/// A bar if standard error is a terminal, unless the user wants none.
[[nodiscard]] ProgressStyle progress_style(ProgressStyle wanted);

/// One line on standard error that shows what is going on; it is wiped when all is over.
class Progress {
public:
    explicit Progress(ProgressStyle style) : style_(style) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { wipe(); }

    /// Something begins whose length is not known. What begins again and again is not drawn
    /// each time.
    void begin(std::string_view stage);
    /// So much of the current stage is done. Cheap enough to be called a million times.
    void update(std::size_t num_done, std::size_t num_all);
    /// The same, with something to say beside the bar: `text()` is asked for when it is drawn.
    void update(std::size_t num_done, std::size_t num_all,
                const std::function<std::string()>& text);
    /// Takes the line away, so that something else can be printed.
    void wipe();

private:
    void draw(const std::string& line);

    ProgressStyle style_;
    std::string stage_;
    std::set<std::string> stages_;
    std::chrono::steady_clock::time_point drawn_at_;
    std::size_t percent_ = 0;
    std::size_t num_drawn_ = 0;
};

}  // namespace quadcut
