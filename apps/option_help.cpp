// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/option_help.hpp"

#include <array>
#include <charconv>
#include <variant>

#include "io/nearest_word.hpp"
#include "io/option_text.hpp"

namespace quadcut {
namespace {

/// 0.3, 1000000: never with an exponent. @pre |value| < 1e20
std::string number_text(double value) {
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
            .ptr;
    return {buffer.data(), end};
}

}  // namespace

std::string range_of(const OptionField& field) {
    if (const auto* choice = std::get_if<Choice>(&field.value)) return io::either_of(choice->words);
    const bool is_whole = !std::holds_alternative<double*>(field.value);
    std::string words;
    if (const auto* counted = std::get_if<CountOrWord>(&field.value)) {
        for (const auto& [word, value] : counted->words) words += std::string(word) + ", ";
        words += "or ";
    }
    return words + (is_whole ? "whole, " : "") + number_text(field.low) + " to " +
           number_text(field.high) + (field.unit.empty() ? "" : " " + std::string(field.unit));
}

std::string facts_of(const OptionField& field) {
    return range_of(field) + ", default " + io::option_text(field);
}

}  // namespace quadcut
