// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/line_of_sight.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace quadcut {
namespace {

constexpr std::int64_t kWordBits = 64;

/// The `count` lowest bits, all of them from 64 on.
std::uint64_t low_bits(std::int64_t count) {
    return count >= kWordBits ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

}  // namespace

BlockedCells::Bits::Bits(std::int64_t first_column, std::int64_t first_row, std::int64_t columns,
                         std::int64_t rows)
    : low_column(first_column - 1),
      low_row(first_row - 1),
      num_rows(rows + 2),
      // One word more than the bits need, so that from() may read across the end of a row.
      words_per_row((columns + 2 + kWordBits - 1) / kWordBits + 1),
      words(static_cast<std::size_t>(num_rows * words_per_row), ~std::uint64_t{0}) {}

std::uint64_t BlockedCells::Bits::from(std::int64_t row, std::int64_t column) const {
    const std::int64_t bit = column - low_column;
    const std::size_t word = static_cast<std::size_t>((row - low_row) * words_per_row + (bit >> 6));
    const auto shift = static_cast<unsigned>(bit & 63);
    // Two shifts, because one by 64 is not defined.
    return (words[word] >> shift) | ((words[word + 1] << 1U) << (63U - shift));
}

bool BlockedCells::Bits::any(std::int64_t row, std::int64_t first, std::int64_t last) const {
    for (; last - first >= kWordBits; first += kWordBits) {
        if (from(row, first) != 0) return true;
    }
    return (from(row, first) & low_bits(last - first + 1)) != 0;
}

void BlockedCells::Bits::clear(std::int64_t row, std::int64_t first, std::int64_t last) {
    const std::size_t row_word = static_cast<std::size_t>((row - low_row) * words_per_row);
    for (std::int64_t bit = first - low_column; bit <= last - low_column;) {
        const std::int64_t offset = bit & 63;
        const std::int64_t count = std::min(kWordBits - offset, last - low_column - bit + 1);
        words[row_word + static_cast<std::size_t>(bit >> 6)] &= ~(low_bits(count) << offset);
        bit += count;
    }
}

BlockedCells::BlockedCells(Cell low, Cell high)
    : low_(low),
      high_(high),
      rows_(low.x, low.y, std::max(0, high.x - low.x + 1), std::max(0, high.y - low.y + 1)),
      columns_(low.y, low.x, std::max(0, high.y - low.y + 1), std::max(0, high.x - low.x + 1)) {
    if (low.x > high.x || low.y > high.y) {
        throw std::logic_error("BlockedCells: the rectangle is empty");
    }
}

BlockedCells::BlockedCells(const LeafTable& table, Cell low, Cell high) : BlockedCells(low, high) {
    table.for_each_leaf_in(low, high, [&](LeafId id) {
        const Leaf& leaf = table.leaf(id);
        if (leaf.state == CellState::free) open_square(leaf.lower_left, leaf.side_cells());
    });
}

void BlockedCells::open_square(Cell lower_left, std::int32_t side_cells) {
    const std::int32_t first_x = std::max(lower_left.x, low_.x);
    const std::int32_t first_y = std::max(lower_left.y, low_.y);
    const std::int32_t last_x = std::min(lower_left.x + (side_cells - 1), high_.x);
    const std::int32_t last_y = std::min(lower_left.y + (side_cells - 1), high_.y);
    for (std::int32_t y = first_y; y <= last_y; ++y) rows_.clear(y, first_x, last_x);
    for (std::int32_t x = first_x; x <= last_x; ++x) columns_.clear(x, first_y, last_y);
}

/// A segment on its way across the lattice, in a frame where it runs along u > 0 and |dv| <= du.
/// The rows of the frame are rows of the map for a flat segment, columns for a steep one; a falling
/// segment is mirrored, v to -v, and with it row r to -1 - r.
class BlockedCells::Walk {
public:
    Walk(const Bits& bits, HalfCell from, HalfCell to)
        : bits_(bits),
          falls_(to.y < from.y),
          u_(from.x),
          v_(falls_ ? -from.y : from.y),
          du_(to.x - from.x),
          dv_(std::abs(to.y - from.y)) {}

    /// Whether the part with u_first <= u <= u_last is clear. u_first <= u_last.
    [[nodiscard]] bool is_clear(std::int64_t u_first, std::int64_t u_last) const {
        return dv_ == 0 ? level_is_clear(u_first, u_last) : slope_is_clear(u_first, u_last);
    }

private:
    [[nodiscard]] std::int64_t map_row(std::int64_t row) const { return falls_ ? -1 - row : row; }

    /// Whether two diagonally opposite blocked cells meet at one of the corners first .. last of
    /// the line between row - 1 and row. Corner c lies between columns c - 1 and c.
    [[nodiscard]] bool any_pinch(std::int64_t row, std::int64_t first, std::int64_t last) const {
        for (std::int64_t corner = first; corner <= last; corner += kWordBits - 1) {
            const std::uint64_t below = bits_.from(map_row(row - 1), corner - 1);
            const std::uint64_t above = bits_.from(map_row(row), corner - 1);
            const std::uint64_t pinches = ((below << 1U) & above) | (below & (above << 1U));
            if (((pinches >> 1U) & low_bits(last - corner + 1)) != 0) return true;
        }
        return false;
    }

    /// A segment parallel to the rows: inside one, or on the line between two.
    [[nodiscard]] bool level_is_clear(std::int64_t u_first, std::int64_t u_last) const {
        const std::int64_t row = v_ >> 1;
        const std::int64_t first = u_first >> 1;
        const std::int64_t last = ((u_last + 1) >> 1) - 1;
        if ((v_ & 1) != 0) return first > last || !bits_.any(map_row(row), first, last);
        for (std::int64_t column = first; column <= last; column += kWordBits) {
            const std::uint64_t both =
                bits_.from(map_row(row - 1), column) & bits_.from(map_row(row), column);
            if ((both & low_bits(last - column + 1)) != 0) return false;
        }
        return !any_pinch(row, (u_first + 1) >> 1, u_last >> 1);
    }

    /// Row by row: the cells that the segment enters in a row are one run of bits. `crossing` is
    /// where it leaves the row, in cells along u, as a mixed fraction, so that every comparison is
    /// exact and the way to the next row is an addition.
    [[nodiscard]] bool slope_is_clear(std::int64_t u_first, std::int64_t u_last) const {
        const std::int64_t rise = (u_first - u_) * dv_ + v_ * du_;
        std::int64_t row = floor_divide(rise, 2 * du_);
        std::int64_t column = u_first >> 1;
        const bool starts_at_corner = rise == row * 2 * du_ && (u_first & 1) == 0;
        if (starts_at_corner && any_pinch(row, column, column)) return false;
        const std::int64_t denominator = 2 * dv_;
        const std::int64_t numerator = u_ * dv_ + (2 * (row + 1) - v_) * du_;
        std::int64_t crossing = floor_divide(numerator, denominator);
        std::int64_t rest = numerator - crossing * denominator;
        const std::int64_t step = du_ / dv_;
        const std::int64_t step_rest = 2 * (du_ - step * dv_);
        const std::int64_t end = u_last >> 1;
        const std::int64_t end_rest = (u_last & 1) * dv_;
        while (crossing < end || (crossing == end && rest < end_rest)) {
            if (bits_.any(map_row(row), column, rest == 0 ? crossing - 1 : crossing)) return false;
            ++row;
            if (rest == 0 && any_pinch(row, crossing, crossing)) return false;
            column = crossing;
            crossing += step;
            rest += step_rest;
            if (rest >= denominator) {
                rest -= denominator;
                ++crossing;
            }
        }
        const std::int64_t last = ((u_last + 1) >> 1) - 1;
        if (column <= last && bits_.any(map_row(row), column, last)) return false;
        const bool ends_at_corner = end_rest == 0 && crossing == end && rest == 0;
        return !(ends_at_corner && any_pinch(row + 1, end, end));
    }

    static std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
        const std::int64_t quotient = a / b;
        return quotient * b > a ? quotient - 1 : quotient;
    }

    const Bits& bits_;
    bool falls_;
    std::int64_t u_;
    std::int64_t v_;
    std::int64_t du_;
    std::int64_t dv_;
};

bool BlockedCells::sees(HalfCell a, HalfCell b, std::int64_t clear_a, std::int64_t clear_b) const {
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep) {
        std::swap(a.x, a.y);
        std::swap(b.x, b.y);
    }
    if (b.x < a.x) {
        std::swap(a, b);
        std::swap(clear_a, clear_b);
    }
    return Walk(steep ? columns_ : rows_, a, b).is_clear(a.x + clear_a, b.x - clear_b);
}

}  // namespace quadcut
