// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/option_help.hpp"

#include <array>
#include <charconv>
#include <variant>

namespace quadcut {
namespace {

std::string number_text(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

}  // namespace

std::string range_of(const OptionField& field) {
    if (const auto* choice = std::get_if<Choice>(&field.value)) {
        std::string text;
        for (std::size_t i = 0; i < choice->words.size(); ++i) {
            if (i > 0) text += i + 1 < choice->words.size() ? ", " : " or ";
            text += choice->words[i];
        }
        return text;
    }
    const bool is_count = std::holds_alternative<std::size_t*>(field.value);
    return (is_count ? "whole, " : "") + number_text(field.low) + " to " + number_text(field.high) +
           (field.unit.empty() ? "" : " " + std::string(field.unit));
}

std::string facts_of(const OptionField& field) {
    return range_of(field) + ", default " + option_text(field);
}

}  // namespace quadcut
