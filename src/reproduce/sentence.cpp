// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/sentence.hpp"

#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"

namespace quadcut::reproduce {
std::string with_commas(std::string number) {
    const std::size_t first = number.front() == '-' ? 1 : 0;
    for (std::size_t at = std::min(number.find('.'), number.size()); at > first + 3;) {
        at -= 3;
        number.insert(at, ",");
    }
    return number;
}

std::string in_words(double value) {
    if (!std::isfinite(value)) return "no number";
    const double magnitude = std::abs(value);
    const int decimals = magnitude >= 100.0 ? 0 : magnitude >= 10.0 ? 1 : magnitude >= 0.1 ? 2 : 4;
    return with_commas(io::rounded(value, decimals));
}

std::string speed_against(double ours_ms, double theirs_ms) {
    const double ratio = theirs_ms / ours_ms;
    if (ratio > 1.1) return in_words(ratio) + " times as fast as";
    if (ratio < 1.0 / 1.1) return in_words(1.0 / ratio) + " times as slow as";
    return "about as fast as";
}

}  // namespace quadcut::reproduce
