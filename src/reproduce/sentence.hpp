// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

namespace quadcut::reproduce {

// Sentences made of measured numbers.

/// A number with commas between its thousands: 17,300.25.
[[nodiscard]] std::string with_commas(std::string number);

/// Two or three significant digits, thousands with commas: 17,300, 43, 0.31; "no number" for
/// what is not finite.
[[nodiscard]] std::string in_words(double value);

/// "3.2 times as long as", "a 284th of the time of" is harder to read than what this says:
/// "284 times as fast as" or "3.2 times as slow as", of ours against theirs; "about as fast as"
/// within a tenth.
[[nodiscard]] std::string speed_against(double ours_ms, double theirs_ms);

}  // namespace quadcut::reproduce
