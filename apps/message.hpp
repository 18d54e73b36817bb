// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadcut {

/// A message as it is printed: one line of text that is safe to show, whatever a file is called and
/// whatever is in it. Control characters and bytes that are no text become '?'; of a word of more
/// than 90 characters the middle is left out, and of a message of more than 1,000.
[[nodiscard]] std::string shown_message(std::string_view message);

/// `message` with less of those of the `typed` words that are longer than 90 characters: who typed
/// them knows them.
[[nodiscard]] std::string without_long_words(std::string message,
                                             std::span<const std::string> typed);

/// One line on standard error, `quadcut: ...`, as shown_message() says.
void print_error(std::string_view message);

/// `quadcut: warning: ...`, a line each.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace quadcut
