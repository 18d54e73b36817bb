// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/gallery/exhibit.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::gallery {

/// What a free cell of an exhibit comes to.
enum class Verdict : std::uint8_t {
    none,        ///< no floor, or nobody says anything of it
    right,       ///< in the match of its true room
    wrong,       ///< in another room than that
    unlabelled,  ///< in a true room, and in none of the result
    left_out     ///< in a room of the result that counts nowhere
};

/// The side between a cell and the next one to the right, or the one above.
struct CellSide {
    Cell cell;
    bool is_upper = false;
    friend bool operator==(const CellSide&, const CellSide&) = default;
};

/// What is wrong, cell by cell, and border by border: between free cells with a label on both
/// sides.
struct Faults {
    Raster<Verdict> verdicts;
    /// Borders of the result, near one of the truth.
    std::vector<CellSide> agreed;
    /// Borders of the result within a true room.
    std::vector<CellSide> over_cut;
    /// Borders of the truth within a room of the result.
    std::vector<CellSide> missed;
    /// The pairs of rooms that these borders lie between, where they have kLeastCutM or more.
    std::size_t num_over_cuts = 0;
    std::size_t num_missed_cuts = 0;
};

/// Shorter borders are what is left beside one that agrees.
inline constexpr double kLeastCutM = 0.4;
/// A border so far beside the true one is the true one.
inline constexpr double kSameBorderM = 0.6;

/// O(cells).
[[nodiscard]] Faults find_faults(const Exhibit& exhibit);

}  // namespace quadcut::gallery
