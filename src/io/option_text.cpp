// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/option_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <system_error>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

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

double parse_number(const OptionField& field, std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
        value < field.low || value > field.high) {
        reject(field, text, "a number from " + quoted_range(field));
    }
    return value;
}

std::size_t parse_count(const OptionField& field, std::string_view text) {
    std::size_t value = 0;
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
        std::string expected = "one of";
        for (const std::string_view word : choice.words) expected += " " + std::string(word);
        reject(field, text, expected);
    }
    *choice.value = static_cast<std::uint8_t>(found - choice.words.begin());
}

/// Levenshtein distance: insertions, deletions, replacements.
std::size_t num_edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

void set_option(const std::vector<OptionField>& fields, std::string_view name,
                std::string_view text) {
    for (const OptionField& field : fields) {
        if (field.name != name) continue;
        if (const auto* number = std::get_if<double*>(&field.value)) {
            **number = parse_number(field, text);
        } else if (const auto* count = std::get_if<std::size_t*>(&field.value)) {
            **count = parse_count(field, text);
        } else {
            choose(field, std::get<Choice>(field.value), text);
        }
        return;
    }
    std::vector<std::string_view> known;
    for (const OptionField& field : fields) known.push_back(field.name);
    const std::string_view nearest = nearest_word(name, known);
    throw InputError("unknown option '" + std::string(name) + "'" +
                     (nearest.empty() ? "" : ": did you mean '" + std::string(nearest) + "'?"));
}

std::string option_text(const OptionField& field) {
    if (const auto* number = std::get_if<double*>(&field.value)) return number_text(**number);
    if (const auto* count = std::get_if<std::size_t*>(&field.value)) {
        return std::to_string(**count);
    }
    const Choice& choice = std::get<Choice>(field.value);
    return std::string(choice.words[*choice.value]);
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known) {
    std::string_view nearest;
    std::size_t fewest = std::max<std::size_t>(3, word.size() / 2);
    for (const std::string_view candidate : known) {
        const std::size_t edits = num_edits(word, candidate);
        if (edits < fewest) {
            fewest = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace quadcut::io
