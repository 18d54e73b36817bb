// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/message.hpp"

#include <algorithm>
#include <iostream>

namespace quadcut {
namespace {

std::string one_line(std::string_view message) {
    std::string line(message);
    std::replace_if(
        line.begin(), line.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    return line;
}

}  // namespace

void print_error(std::string_view message) { std::cerr << "quadcut: " + one_line(message) + "\n"; }

void print_warnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) print_error("warning: " + warning);
}

}  // namespace quadcut
