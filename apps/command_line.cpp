// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/command_line.hpp"

#include <string_view>

namespace quadcut {
namespace {

/// Characters that a shell takes as they are.
bool is_plain(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+:,@%";
    return !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
}

std::string quoted(const std::string& word) {
    if (is_plain(word)) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

}  // namespace

std::string command_line(std::span<const std::string> words) {
    std::string line = "quadcut";
    for (const std::string& word : words) line += " " + quoted(word);
    return line;
}

}  // namespace quadcut
