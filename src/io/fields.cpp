// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/fields.hpp"

#include <charconv>

namespace quadcut::io {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

template <typename Number>
std::optional<Number> parse_whole(std::string_view text) {
    // from_chars knows no plus, which some writers put before an exponent's mantissa.
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) { return parse_whole<double>(text); }

std::optional<std::int64_t> parse_integer(std::string_view text) {
    return parse_whole<std::int64_t>(text);
}

std::string_view Fields::next() {
    std::size_t first = 0;
    while (first < rest_.size() && is_space(rest_[first])) ++first;
    std::size_t last = first;
    while (last < rest_.size() && !is_space(rest_[last])) ++last;
    const std::string_view field = rest_.substr(first, last - first);
    rest_.remove_prefix(last);
    return field;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    }
    return lower;
}

std::string quote(std::string_view text) {
    constexpr std::size_t kMaxShown = 40;
    constexpr unsigned char kFirstPrintable = 0x20;
    constexpr unsigned char kDelete = 0x7F;
    std::string shown = "\"";
    for (const char c : text.substr(0, kMaxShown)) {
        const auto byte = static_cast<unsigned char>(c);
        shown.push_back(byte < kFirstPrintable || byte >= kDelete ? '?' : c);
    }
    if (text.size() > kMaxShown) shown += "...";
    return shown + "\"";
}

}  // namespace quadcut::io
