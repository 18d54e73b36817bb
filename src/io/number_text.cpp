// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace quadcut::io {
namespace {

// 309 digits, a point, a sign, and any decimals we ask for.
constexpr std::size_t kMaxDigits = 352;

}  // namespace

void append_rounded(std::string& text, double value, int max_decimals) {
    if (!std::isfinite(value)) {
        text += "null";
        return;
    }
    std::array<char, kMaxDigits> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, max_decimals);
    std::string_view number(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
    if (number.find('.') != std::string_view::npos) {
        number = number.substr(0, number.find_last_not_of('0') + 1);
        if (number.back() == '.') number.remove_suffix(1);
    }
    text += number == "-0" ? std::string_view("0") : number;
}

std::string rounded(double value, int max_decimals) {
    std::string text;
    append_rounded(text, value, max_decimals);
    return text;
}

std::string with_decimals(double value, int decimals) {
    std::array<char, kMaxDigits> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, decimals);
    return {digits.data(), end.ptr};
}

void append_exact(std::string& text, double value) {
    if (!std::isfinite(value)) {
        text += std::isnan(value) ? "NaN" : value > 0.0 ? "Infinity" : "-Infinity";
        return;
    }
    std::array<char, kMaxDigits> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    const std::string_view number(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
    text += number;
    if (number.find_first_of(".e") == std::string_view::npos) text += ".0";
}

std::string exact(double value) {
    std::string text;
    append_exact(text, value);
    return text;
}

}  // namespace quadcut::io
