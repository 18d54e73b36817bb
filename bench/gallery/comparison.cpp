// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/comparison.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quadcut::gallery {
namespace {

constexpr double kFoundIou = 0.5;

/// Of each region of `image`, how much lies where in `other`.
std::vector<Fate> fates_in(const io::LabelImage& image, const io::LabelImage& other,
                           const std::vector<std::uint8_t>& is_found) {
    const std::size_t num_columns = other.num_regions + std::size_t{1};
    std::vector<std::size_t> shared((image.num_regions + std::size_t{1}) * num_columns);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        ++shared[image.values[i] * num_columns + other.values[i]];
    }
    std::vector<Fate> fates(image.num_regions, Fate::found);
    for (std::size_t i = 0; i < fates.size(); ++i) {
        if (is_found[i] != 0) continue;
        const std::size_t* const row = shared.data() + (i + 1) * num_columns;
        std::size_t labelled = 0;
        std::size_t most = 0;
        for (std::size_t j = 1; j < num_columns; ++j) {
            labelled += row[j];
            most = std::max(most, row[j]);
        }
        fates[i] = labelled < row[0]     ? Fate::unseen
                   : 2 * most > labelled ? Fate::swallowed
                                         : Fate::divided;
    }
    return fates;
}

using Words = std::array<std::string_view, 4>;
constexpr Words kTrueWords = {"", "merged", "split", "missing"};
constexpr Words kPredictedWords = {"", "split", "merged", "false"};

std::string count_words(const std::vector<Fate>& fates, const Words& words) {
    std::string text;
    for (std::size_t kind = 1; kind < words.size(); ++kind) {
        const auto number = std::count(fates.begin(), fates.end(), static_cast<Fate>(kind));
        if (number == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(number) + " ";
        text += words.at(kind);
    }
    return text;
}

}  // namespace

Comparison compare(const io::LabelImage& predicted, const io::LabelImage& truth) {
    Comparison comparison;
    comparison.score = eval::score_rooms(predicted, truth);
    std::vector<std::uint8_t> predicted_found(predicted.num_regions);
    std::vector<std::uint8_t> truth_found(truth.num_regions);
    for (const eval::RoomMatch& match : eval::match_rooms(predicted, truth)) {
        if (match.iou <= kFoundIou) continue;
        comparison.found.push_back(match);
        predicted_found[match.predicted - 1] = 1;
        truth_found[match.truth - 1] = 1;
    }
    comparison.truth = fates_in(truth, predicted, truth_found);
    comparison.predicted = fates_in(predicted, truth, predicted_found);
    return comparison;
}

std::string_view word_for_true(Fate fate) { return kTrueWords.at(static_cast<std::size_t>(fate)); }

std::string_view word_for_predicted(Fate fate) {
    return kPredictedWords.at(static_cast<std::size_t>(fate));
}

std::string error_text(const Comparison& comparison) {
    const std::string of_truth = count_words(comparison.truth, kTrueWords);
    const std::string of_result = count_words(comparison.predicted, kPredictedWords);
    if (of_truth.empty() && of_result.empty()) return "no errors";
    std::string text;
    if (!of_truth.empty()) text += "true rooms: " + of_truth;
    if (!of_result.empty()) text += (text.empty() ? "result: " : "; result: ") + of_result;
    return text;
}

}  // namespace quadcut::gallery
