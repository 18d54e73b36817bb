// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/message.hpp"

#include <algorithm>
#include <cstddef>
#include <iostream>

#include "io/utf8.hpp"

namespace quadcut {
namespace {

constexpr std::u32string_view kLeftOut = U"...";
constexpr std::size_t kLongestWord = 90;
constexpr std::size_t kLongestMessage = 1000;

/// Nothing to see: C0, delete, C1; and what turns the direction or breaks the line of all that
/// follows.
bool is_unsafe(char32_t c) {
    const bool is_control = c < 0x20 || (c >= 0x7F && c < 0xA0);
    const bool is_direction = c == 0x200E || c == 0x200F || (c >= 0x2066 && c <= 0x2069);
    return is_control || is_direction || (c >= 0x2028 && c <= 0x202E);
}

std::u32string safe_text(std::string_view bytes) {
    std::u32string text = io::decode_utf8(bytes);
    std::replace_if(
        text.begin(), text.end(),
        [](char32_t c) { return is_unsafe(c) || c == io::kReplacementCharacter; }, U'?');
    return text;
}

std::string to_bytes(std::u32string_view text) {
    std::string bytes;
    for (const char32_t c : text) io::append_utf8(bytes, c);
    return bytes;
}

/// Both ends of a text: a file's name is at the end of its path.
std::u32string cut(std::u32string_view text, std::size_t longest) {
    if (text.size() <= longest) return std::u32string(text);
    const std::size_t num_last = (longest - kLeftOut.size()) / 2;
    std::u32string ends(text.substr(0, longest - kLeftOut.size() - num_last));
    return ends.append(kLeftOut).append(text.substr(text.size() - num_last));
}

/// Wherever it is in the message.
void shorten(std::string& message, std::string_view word) {
    if (word.size() <= kLongestWord) return;
    const std::string shorter = to_bytes(cut(safe_text(word), kLongestWord));
    std::size_t at = 0;
    while ((at = message.find(word, at)) != std::string::npos) {
        message.replace(at, word.size(), shorter);
        at += shorter.size();
    }
}

}  // namespace

std::string shown_message(std::string_view message) {
    const std::u32string text = safe_text(message);
    std::u32string shown;
    std::u32string_view rest = text;
    while (!rest.empty()) {
        const std::size_t length = std::min(rest.find(U' '), rest.size());
        shown += cut(rest.substr(0, length), kLongestWord);
        rest.remove_prefix(length);
        if (rest.empty()) break;
        shown += U' ';
        rest.remove_prefix(1);
    }
    return to_bytes(cut(shown, kLongestMessage));
}

std::string without_long_words(std::string message, std::span<const std::string> typed) {
    for (const std::string& word : typed) {
        // `--set=NAME=VALUE`: a message may repeat any part of it.
        std::string_view rest = word;
        for (int i = 0; i < 3; ++i) {
            const std::size_t equals = std::min(rest.find('='), rest.size());
            shorten(message, rest);
            shorten(message, rest.substr(0, equals));
            rest.remove_prefix(std::min(equals + 1, rest.size()));
        }
    }
    return message;
}

void print_error(std::string_view message) {
    std::cerr << "quadcut: " + shown_message(message) + "\n";
}

void print_warnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) print_error("warning: " + warning);
}

}  // namespace quadcut
