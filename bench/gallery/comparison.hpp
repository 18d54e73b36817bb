// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eval/score.hpp"
#include "io/label_image.hpp"

namespace quadcut::gallery {

/// What became of a room on the other side of a comparison.
enum class Fate : std::uint8_t {
    found,      ///< a match with IoU > 0.5
    swallowed,  ///< most of it lies in one larger room of the other side
    divided,    ///< it lies in several rooms of the other side, in none mostly
    unseen      ///< less than half of it has a label on the other side
};

/// A result held against the truth: the score, and which rooms it is made of. Rooms are the
/// regions of the two images; truth[i] and predicted[i] tell of region i + 1.
struct Comparison {
    eval::RoomScore score;
    /// Those with IoU > 0.5.
    std::vector<eval::RoomMatch> found;
    std::vector<Fate> truth;
    std::vector<Fate> predicted;
};

/// O(pixels + rooms^2 truth). Throws InputError when the images differ in size.
[[nodiscard]] Comparison compare(const io::LabelImage& predicted, const io::LabelImage& truth);

/// What to call it: a true room is merged, split or missing; a predicted one is merged (it holds
/// several true rooms), split (a part of one) or false. Empty for a room that was found.
[[nodiscard]] std::string_view word_for_true(Fate fate);
[[nodiscard]] std::string_view word_for_predicted(Fate fate);

/// All errors in a few words: "true rooms: 2 merged; result: 1 false". "no errors" if none.
[[nodiscard]] std::string error_text(const Comparison& comparison);

}  // namespace quadcut::gallery
