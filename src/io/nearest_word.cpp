// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/nearest_word.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "io/fields.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kFar = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMostWords = 3;
constexpr std::string_view kLongDash = "\xE2\x80\x93";
constexpr std::string_view kLongerDash = "\xE2\x80\x94";
/// A word that goes on where another ends: "segmentation". Shorter ones begin too many.
constexpr std::size_t kShortestBeginning = 3;

// How far words are that have this in common; edits come after all of them.
constexpr std::size_t kSameLastPart = 1;
constexpr std::size_t kBeginning = 2;
constexpr std::size_t kPart = 3;

/// What counts of a word.
std::string key_of(std::string_view word) {
    if (has_long_dash(word)) word.remove_prefix(kLongDash.size());
    word.remove_prefix(std::min(word.find_first_not_of('-'), word.size()));
    std::string key = lower_case(word);
    std::replace(key.begin(), key.end(), '_', '-');
    return key;
}

std::string_view last_part(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

bool begins(std::string_view text, std::string_view with) {
    return text.substr(0, with.size()) == with;
}

bool has_part(std::string_view text, std::string_view part) {
    const std::string parts = "-" + std::string(text) + "-";
    return parts.find("-" + std::string(part) + "-") != std::string::npos;
}

/// Damerau's distance: insertions, deletions, replacements, neighbours that changed places.
std::size_t num_edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    std::vector<std::size_t> next(b.size() + 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        next[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = row[j] + (a[i] == b[j] ? 0 : 1);
            next[j + 1] = std::min({replaced, row[j + 1] + 1, next[j] + 1});
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) {
                next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
            }
        }
        std::swap(before, row);
        std::swap(row, next);
    }
    return row.back();
}

std::size_t distance_by_edits(std::string_view word, std::string_view known) {
    // A third of the letters; of two words that have nothing in common none is meant.
    const std::size_t most = (std::min(word.size(), known.size()) + 1) / 3;
    const std::size_t longer = std::max(word.size(), known.size());
    if (longer - std::min(word.size(), known.size()) > most) return kFar;
    const std::size_t edits = num_edits(word, known);
    return edits > most ? kFar : kPart + edits;
}

std::size_t distance(std::string_view word, std::string_view known) {
    if (word == known) return 0;
    const std::string_view end = last_part(word);
    const std::string_view known_end = last_part(known);
    if (end.empty()) return kFar;
    if (end == known_end) return kSameLastPart;
    const bool is_longer = known_end.size() >= kShortestBeginning && begins(end, known_end);
    if (is_longer || begins(known_end, end)) return kBeginning;
    if (has_part(known_end, end)) return kPart;
    return std::min(distance_by_edits(word, known), distance_by_edits(end, known_end));
}

}  // namespace

bool has_long_dash(std::string_view word) {
    const std::string_view start = word.substr(0, kLongDash.size());
    return start == kLongDash || start == kLongerDash;
}

std::vector<std::string_view> nearest_words(std::string_view word,
                                            const std::vector<std::string_view>& known) {
    const std::string key = key_of(word);
    std::vector<std::string_view> nearest;
    std::size_t least = kFar;
    for (const std::string_view candidate : known) {
        const std::size_t far = distance(key, key_of(candidate));
        if (far < least) nearest.clear();
        least = std::min(least, far);
        if (far != kFar && far == least) nearest.push_back(candidate);
    }
    if (nearest.size() > kMostWords) nearest.resize(kMostWords);
    return nearest;
}

std::string either_of(const std::vector<std::string_view>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 < words.size() ? ", " : " or ";
        text += words[i];
    }
    return text;
}

std::string did_you_mean(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "did you mean '" : " or '") + word + "'";
    }
    return text.empty() ? "" : text + "?";
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& known,
                       const std::string& otherwise) {
    const std::vector<std::string_view> nearest = nearest_words(word, known);
    if (nearest.empty()) return otherwise;
    return ": " + did_you_mean({nearest.begin(), nearest.end()});
}

}  // namespace quadcut::io
