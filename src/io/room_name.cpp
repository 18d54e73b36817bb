// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_name.hpp"

#include <algorithm>

#include "io/utf8.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kMaxCharacters = 200;

/// Unicode's White_Space, and what has no width.
bool is_space(char32_t c) {
    return (c >= 0x09 && c <= 0x0D) || c == 0x20 || c == 0x85 || c == 0xA0 || c == 0x1680 ||
           (c >= 0x2000 && c <= 0x200B) || c == 0x2028 || c == 0x2029 || c == 0x202F ||
           c == 0x205F || c == 0x2060 || c == 0x3000 || c == 0xFEFF;
}

/// C0 and C1, line and paragraph separators, and what turns the direction of text.
bool is_control(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x2028 && c <= 0x202E) ||
           (c >= 0x2066 && c <= 0x2069);
}

}  // namespace

std::string trimmed_room_name(std::string_view name) {
    std::u32string text = decode_utf8(name);
    std::string same;
    for (const char32_t c : text) append_utf8(same, c);
    if (same != name) throw InputError("a room's name is no text: expected UTF-8");
    const auto first = std::find_if_not(text.begin(), text.end(), is_space);
    text.erase(text.begin(), first);
    while (!text.empty() && is_space(text.back())) text.pop_back();
    const bool is_printable = std::none_of(text.begin(), text.end(), is_control);
    if (text.empty() || text.size() > kMaxCharacters || !is_printable) {
        throw InputError("a room's name of " + std::to_string(text.size()) +
                         " characters: expected 1 to 200 and no control characters");
    }
    std::string trimmed;
    for (const char32_t c : text) append_utf8(trimmed, c);
    return trimmed;
}

}  // namespace quadcut::io
