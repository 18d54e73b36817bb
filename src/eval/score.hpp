// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/label_image.hpp"

namespace quadcut::eval {

/// How well a segmentation agrees with the true rooms. Pixels that either side leaves at 0 do not
/// count towards overlap. All are 1 for a perfect result but vi_over, vi_under (0, bits).
struct RoomScore {
    /// Panoptic quality: the sum of IoU over matches with IoU > 0.5, over (truth + rooms) / 2.
    double pq = 0.0;
    /// F1 of the rooms that are found at IoU > 0.5 and > 0.7; matches are a best assignment.
    double f1_50 = 0.0;
    double f1_70 = 0.0;
    /// Mean IoU of the matched rooms, over the number of true rooms.
    double miou = 0.0;
    /// Mean over predicted rooms of their largest share in one true room (Bormann et al. 2016).
    double precision = 0.0;
    /// Mean over true rooms of their largest share in one predicted room.
    double recall = 0.0;
    /// Matthews correlation of each matched room; unmatched rooms of either side count 0
    /// (Mielle et al. 2018, corrected).
    double mcc = 0.0;
    /// Adjusted Rand index.
    double ari = 0.0;
    /// The two halves of the variation of information: too many cuts, too few.
    double vi_over = 0.0;
    double vi_under = 0.0;
    /// The share of the true rooms' pixels (their free ones, given a mask) that has any label.
    /// Not a number if there are none.
    double cover = 0.0;
    std::uint32_t rooms = 0;
    std::uint32_t truth = 0;
};

/// Compares two segmentations of one map. Cost: the pixels, and rooms^2 * truth for the assignment.
/// Throws InputError that names both sizes when the images (or the mask) differ in size, and when
/// there are too many regions to compare (rooms * truth above 2^24).
[[nodiscard]] RoomScore score_rooms(const io::LabelImage& predicted, const io::LabelImage& truth,
                                    const std::optional<io::FreeMask>& free_mask = std::nullopt);

/// The prediction less the regions that lie, by more than half of their free cells (of all their
/// cells without a mask), where the truth has no room: what nobody can name (rays through glass,
/// the ground outside) counts nowhere. The free cells are to be certain ones (io::kSurelyFreeGrey).
/// Numbered anew. O(pixels). Errors of sizes as score_rooms.
[[nodiscard]] io::LabelImage without_void(
    const io::LabelImage& predicted, const io::LabelImage& truth,
    const std::optional<io::FreeMask>& surely_free = std::nullopt);

/// A predicted and a true room that belong together; numbers are those of the images.
struct RoomMatch {
    std::uint32_t predicted = 0;
    std::uint32_t truth = 0;
    /// Intersection over union, over the pixels that have a label on both sides. Above 0.
    double iou = 0.0;
    friend bool operator==(const RoomMatch&, const RoomMatch&) = default;
};

/// The one-to-one assignment with the largest sum of IoU, which the score rests on; ascending by
/// predicted room. Cost and errors as score_rooms.
[[nodiscard]] std::vector<RoomMatch> match_rooms(const io::LabelImage& predicted,
                                                 const io::LabelImage& truth);

/// One number a line, in the order above, every digit that is needed to read the same value back.
[[nodiscard]] std::string to_json(const RoomScore& score);

}  // namespace quadcut::eval
