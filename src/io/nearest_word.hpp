// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadcut::io {

/// Whether a word begins with one of the dashes (U+2013, U+2014) that a word processor makes of '-'
/// and "--".
[[nodiscard]] bool has_long_dash(std::string_view word);

/// The words of `known` that `word` may have been meant for: those nearest to it, at most three,
/// in their order; none when all are far. Case, dashes in front and '_' for '-' play no part. Near
/// are, best first: the same word; the same last part ("min_room", "rooms.min_room"); a beginning
/// of the other ("out", "output"); a part ("width", "door_width"); few edits, where two letters
/// that changed places are one.
[[nodiscard]] std::vector<std::string_view> nearest_words(
    std::string_view word, const std::vector<std::string_view>& known);

/// "a, b or c"; empty for no words.
[[nodiscard]] std::string either_of(const std::vector<std::string_view>& words);

/// "did you mean 'a' or 'b'?"; empty for no words.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& words);

/// ": did you mean 'a'?" for the nearest words; `otherwise` when none is near.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string_view>& known,
                                     const std::string& otherwise = "");

}  // namespace quadcut::io
