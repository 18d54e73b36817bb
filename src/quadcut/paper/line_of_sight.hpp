// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/leaf.hpp"
#include "quadcut/map/leaf_table.hpp"

namespace quadcut {

/// Which cells of a rectangle block sight (criterion 1 of the paper): a bit a cell, kept by rows
/// and by columns. A cell outside the rectangle blocks.
///
/// The exact rule. Take the union of the closed blocked cells. A closed segment is blocked when it
/// holds a point of the union's interior, or a corner that two diagonally opposite blocked cells
/// share. So the common border of two blocked cells blocks, the gap between two cells that touch at
/// a corner blocks, and a segment that slides along one blocked cell or touches its corner is free.
class BlockedCells {
public:
    /// All cells of low .. high (both corners included) blocked. O(cells / 64).
    /// Throws std::logic_error if the rectangle is empty.
    BlockedCells(Cell low, Cell high);

    /// The cells of low .. high that no free leaf covers. O(cells / 64 + leaves met).
    BlockedCells(const LeafTable& table, Cell low, Cell high);

    /// Opens the cells of a square, as far as they lie in the rectangle. O(side).
    void open_square(Cell lower_left, std::int32_t side_cells);

    /// Whether nothing blocks the closed segment a-b. `clear_a` and `clear_b` are lengths in half
    /// cells, measured from each end along the longer of the axes, that the caller knows to be
    /// clear: for centres of free leaves, their side_cells(). The same answer with a and b
    /// exchanged (and clear_a with clear_b). O(cells along the shorter axis).
    /// @pre a != b, both on the rectangle, clear_a + clear_b <= max(|dx|, |dy|) < 2^30.
    [[nodiscard]] bool sees(HalfCell a, HalfCell b, std::int64_t clear_a = 0,
                            std::int64_t clear_b = 0) const;

private:
    /// One row of the rectangle after the other, a bit a cell; with a border of one blocked cell,
    /// because a segment on the rim looks at the cells beyond it.
    struct Bits {
        std::int64_t low_column = 0;
        std::int64_t low_row = 0;
        std::int64_t num_rows = 0;
        std::int64_t words_per_row = 0;
        std::vector<std::uint64_t> words;

        Bits(std::int64_t first_column, std::int64_t first_row, std::int64_t columns,
             std::int64_t rows);
        /// The bits of 64 columns from `column` on.
        [[nodiscard]] std::uint64_t from(std::int64_t row, std::int64_t column) const;
        [[nodiscard]] bool any(std::int64_t row, std::int64_t first, std::int64_t last) const;
        void clear(std::int64_t row, std::int64_t first, std::int64_t last);
    };
    class Walk;

    Cell low_;
    Cell high_;
    Bits rows_;
    Bits columns_;
};

}  // namespace quadcut
