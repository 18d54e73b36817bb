// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/option_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

/// What is looked at of a text that is no number.
constexpr std::size_t kLongestNumber = 32;
constexpr int kMeantDecimals = 6;

std::string number_text(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string quoted_range(const OptionField& field) {
    return number_text(field.low) + " to " + number_text(field.high) +
           (field.unit.empty() ? "" : " " + std::string(field.unit));
}

[[noreturn]] void reject(const OptionField& field, std::string_view text,
                         const std::string& expected) {
    throw InputError("option " + std::string(field.name) + ": '" + std::string(text) +
                     "': expected " + expected);
}

/// What a number is multiplied by whose unit is the field's, or a part of a metre; nothing for
/// others.
std::optional<double> factor_of(std::string_view unit, const OptionField& field) {
    if (unit.empty() || unit == field.unit) return 1.0;
    if (field.unit != "m") return std::nullopt;
    if (unit == "cm") return 0.01;
    return unit == "mm" ? std::optional(0.001) : std::nullopt;
}

/// The number that a text means when it is one that is allowed: "0,3", "1.5m", "5 cm".
std::string number_meant(const OptionField& field, std::string_view text) {
    std::string with_point(text.substr(0, kLongestNumber));
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    double value = 0.0;
    const char* const begin = with_point.data();
    const auto [end, error] = std::from_chars(begin, begin + with_point.size(), value);
    std::string_view unit(end, static_cast<std::size_t>(begin + with_point.size() - end));
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    const std::optional<double> factor = factor_of(unit, field);
    if (error != std::errc() || !factor) return "";
    value *= *factor;
    if (!(value >= field.low && value <= field.high)) return "";
    return ": " + did_you_mean({rounded(value, kMeantDecimals)});
}

double parse_number(const OptionField& field, std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
        value < field.low || value > field.high) {
        reject(field, text, "a number from " + quoted_range(field) + number_meant(field, text));
    }
    return value;
}

template <typename Whole>
Whole parse_whole(const OptionField& field, std::string_view text) {
    Whole value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() ||
        static_cast<double>(value) < field.low || static_cast<double>(value) > field.high) {
        reject(field, text, "a whole number from " + quoted_range(field));
    }
    return value;
}

void choose(const OptionField& field, const Choice& choice, std::string_view text) {
    const auto found = std::find(choice.words.begin(), choice.words.end(), text);
    if (found == choice.words.end()) {
        reject(field, text, either_of(choice.words) + suggestion(text, choice.words));
    }
    *choice.value = static_cast<std::uint8_t>(found - choice.words.begin());
}

std::string text_of(const CountOrWord& count) {
    for (const auto& [word, value] : count.words) {
        if (*count.value == value) return std::string(word);
    }
    return std::to_string(*count.value);
}

void set_count_or_word(const OptionField& field, const CountOrWord& count, std::string_view text) {
    std::vector<std::string_view> words;
    for (const auto& [word, value] : count.words) {
        if (text == word) {
            *count.value = value;
            return;
        }
        words.push_back(word);
    }
    const bool is_number = !text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
    if (is_number) {
        *count.value = parse_whole<std::size_t>(field, text);
    } else {
        reject(field, text,
               either_of(words) + ", or a whole number from " + quoted_range(field) +
                   suggestion(text, words));
    }
}

}  // namespace

void set_option(const std::vector<OptionField>& fields, std::string_view name,
                std::string_view text) {
    for (const OptionField& field : fields) {
        if (field.name != name) continue;
        if (const auto* number = std::get_if<double*>(&field.value)) {
            **number = parse_number(field, text);
        } else if (const auto* count = std::get_if<std::size_t*>(&field.value)) {
            **count = parse_whole<std::size_t>(field, text);
        } else if (const auto* whole = std::get_if<int*>(&field.value)) {
            **whole = parse_whole<int>(field, text);
        } else if (const auto* counted = std::get_if<CountOrWord>(&field.value)) {
            set_count_or_word(field, *counted, text);
        } else {
            choose(field, std::get<Choice>(field.value), text);
        }
        return;
    }
    std::vector<std::string_view> known;
    for (const OptionField& field : fields) known.push_back(field.name);
    throw InputError("unknown option '" + std::string(name) + "'" + suggestion(name, known));
}

std::string option_text(const OptionField& field) {
    if (const auto* number = std::get_if<double*>(&field.value)) return number_text(**number);
    if (const auto* count = std::get_if<std::size_t*>(&field.value)) {
        return std::to_string(**count);
    }
    if (const auto* whole = std::get_if<int*>(&field.value)) return std::to_string(**whole);
    if (const auto* counted = std::get_if<CountOrWord>(&field.value)) return text_of(*counted);
    const Choice& choice = std::get<Choice>(field.value);
    return std::string(choice.words[*choice.value]);
}

}  // namespace quadcut::io
