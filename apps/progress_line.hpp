// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace quadcut {

/// What is known of something that goes on.
struct ProgressState {
    /// "follow"
    std::string_view stage;
    /// Of all that is to be done, 0 to 1; nothing when its length is not known.
    std::optional<double> share;
    /// How long the rest will take.
    std::optional<double> left_s;
    /// How fast it goes, in `unit` a second.
    std::optional<double> rate;
    /// "scans"
    std::string_view unit;
    /// What else there is to say: "12 rooms".
    std::string_view more;
};

/// "follow  [#####.....]  47 %  12 s left  1840 scans/s  12 rooms", ASCII, at most `width`
/// characters. Where that is narrow the bar is shortened, and then what matters least is left out:
/// `more`, the bar, the rate, the time, and at last the end of the line.
[[nodiscard]] std::string progress_line(const ProgressState& state, std::size_t width);

/// "12 s", "3 min", "2 h": rounded up, at least a second.
[[nodiscard]] std::string in_words(double seconds);

}  // namespace quadcut
