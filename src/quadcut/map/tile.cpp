// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tile.hpp"

#include <algorithm>
#include <bit>

#include "quadcut/map/morton.hpp"

namespace quadcut {
namespace {

// Exchanges the two index bits whose difference is `shift`: moves the bits under `mask` up by it,
// and those that stand there down.
constexpr std::uint64_t swap_index_bits(std::uint64_t bits, std::uint64_t mask, int shift) {
    const std::uint64_t moved = (bits ^ (bits >> shift)) & mask;
    return bits ^ moved ^ (moved << shift);
}

// The lower left bits of the runs of 4 that are all set among runs that start at a bit of `starts`
// and whose bits are 1 `stride` apart.
constexpr TileMask full_quads(TileMask set, int stride, TileMask starts) {
    const TileMask pairs = set & (set >> stride);
    return pairs & (pairs >> (2 * stride)) & starts;
}

// Eight cells at a time: a row of a tile is the eight bytes of a word, the lowest first.
constexpr std::uint64_t kOnes = 0x0101'0101'0101'0101U;
constexpr std::uint64_t kHighBits = 0x8080'8080'8080'8080U;

std::uint64_t row_of(const Tile& tile, std::size_t y) {
    std::uint64_t row = 0;
    for (std::size_t x = 0; x < 8; ++x) {
        row |= std::uint64_t{static_cast<std::uint8_t>(tile.values[8 * y + x])} << (8 * x);
    }
    return row;
}

// The high bits of eight bytes, as the eight bits of one.
constexpr std::uint64_t gathered(std::uint64_t high_bits) {
    return ((high_bits >> 7U) * 0x0102'0408'1020'4080U) >> 56U;
}

// 0xFF in the bytes whose bit is set.
constexpr std::uint64_t spread(std::uint64_t bits) {
    const std::uint64_t one_bit_each = ((bits & 0xFFU) * kOnes) & 0x8040'2010'0804'0201U;
    const std::uint64_t is_set = ((one_bit_each & ~kHighBits) + ~kHighBits) | one_bit_each;
    return ((is_set & kHighBits) >> 7U) * 0xFFU;
}

constexpr TileMask kQuads = 0x1111'1111'1111'1111U;
constexpr TileMask kSixteens = 0x0001'0001'0001'0001U;

}  // namespace

TileMask morton_from_rows(std::uint64_t rows) {
    // The index is y2 y1 y0 x2 x1 x0 and becomes y2 x2 y1 x1 y0 x0: three exchanges.
    rows = swap_index_bits(rows, 0x0000'F0F0'0000'F0F0U, 12);  // y2 x2 y0 y1 x1 x0
    rows = swap_index_bits(rows, 0x00F0'00F0'00F0'00F0U, 4);   // y2 x2 y1 y0 x1 x0
    return swap_index_bits(rows, 0x0C0C'0C0C'0C0C'0C0CU, 2);
}

std::uint64_t rows_below_zero(const Tile& tile) {
    std::uint64_t rows = 0;
    for (std::size_t y = 0; y < 8; ++y) rows |= gathered(row_of(tile, y) & kHighBits) << (8 * y);
    return rows;
}

std::uint64_t rows_at_least(const Tile& tile, int bound) {
    if (bound > kMaxLogOdds) return 0;
    // Carries into the high bit of the bytes that reach the bound; negative ones have it already.
    const std::uint64_t more = static_cast<std::uint64_t>(128 - bound) * kOnes;
    std::uint64_t rows = 0;
    for (std::size_t y = 0; y < 8; ++y) {
        const std::uint64_t row = row_of(tile, y);
        rows |= gathered(((row & ~kHighBits) + more) & ~row & kHighBits) << (8 * y);
    }
    return rows;
}

Tile bounded_sums(const Tile& tile, std::uint64_t hit, int if_hit, std::uint64_t miss,
                  int if_miss) {
    // Differences beyond the range have the same result as the range.
    static constexpr int kRange = kMaxLogOdds - kMinLogOdds;
    const auto byte = [](int delta) {
        return static_cast<std::uint8_t>(std::clamp(delta, -kRange, kRange)) * kOnes;
    };
    Tile sums;
    for (std::size_t y = 0; y < 8; ++y) {
        const std::uint64_t is_hit = spread(hit >> (8 * y));
        const std::uint64_t is_miss = spread(miss >> (8 * y)) & ~is_hit;
        const std::uint64_t delta = (is_hit & byte(if_hit)) | (is_miss & byte(if_miss));
        for (std::size_t x = 0; x < 8; ++x) {
            sums.values[8 * y + x] = static_cast<std::int8_t>(delta >> (8 * x));
        }
    }
    // Without branches, so that the compiler takes many cells at a time.
    for (std::size_t i = 0; i < kTileCells; ++i) {
        const std::int8_t delta = sums.values[i];
        auto sum = static_cast<std::int8_t>(tile.values[i] + delta);
        sum = sum < kMinLogOdds ? static_cast<std::int8_t>(kMinLogOdds) : sum;
        sum = sum > kMaxLogOdds ? static_cast<std::int8_t>(kMaxLogOdds) : sum;
        const auto sign = static_cast<std::int8_t>((delta > 0) - (delta < 0));
        sums.values[i] = sum == 0 ? sign : sum;
    }
    return sums;
}

TileMask TileStates::of(CellState state) const {
    return state == CellState::free       ? free
           : state == CellState::occupied ? occupied
                                          : ~(free | occupied);
}

CellState TileStates::at(int position) const {
    const TileMask bit = TileMask{1} << position;
    return (free & bit) != 0       ? CellState::free
           : (occupied & bit) != 0 ? CellState::occupied
                                   : CellState::unknown;
}

TileStates states_of(const Tile& tile) {
    return {morton_from_rows(rows_below_zero(tile)), morton_from_rows(rows_at_least(tile, 1))};
}

int TileLeaves::count() const {
    return std::popcount(by_level[0]) + std::popcount(by_level[1]) + std::popcount(by_level[2]);
}

std::array<TileMask, kTileBits> TileLeaves::inner_nodes() const {
    if (count() == 0) {
        return {};
    }
    // A block of 4 is divided when its lower left cell is a leaf; one of 16 when it is none.
    return {by_level[0] & kQuads, kSixteens & ~by_level[2], TileMask{1}};
}

TileLeaves leaves_of(const TileStates& states) {
    TileLeaves leaves;
    TileMask quads = 0;
    TileMask sixteens = 0;
    for (const CellState state : {CellState::unknown, CellState::free, CellState::occupied}) {
        const TileMask cells = states.of(state);
        if (cells == kWholeTile) {
            return {};
        }
        const TileMask quads_of_state = full_quads(cells, 1, kQuads);
        quads |= quads_of_state;
        sixteens |= full_quads(quads_of_state, 4, kSixteens);
    }
    leaves.by_level[2] = sixteens;
    leaves.by_level[1] = quads & ~(sixteens * 0x1111U);
    leaves.by_level[0] = ~(quads * 0xFU);
    return leaves;
}

void append_leaves(const TileLeaves& in_tile, const TileStates& states, Cell corner,
                   std::vector<Leaf>& leaves) {
    const auto& [cells, quads, sixteens] = in_tile.by_level;
    for (TileMask left = cells | quads | sixteens; left != 0; left &= left - 1) {
        const int place = std::countr_zero(left);
        const TileMask bit = TileMask{1} << place;
        const Cell cell = morton_position(static_cast<std::uint64_t>(place));
        const int level = (cells & bit) != 0 ? 0 : (quads & bit) != 0 ? 1 : 2;
        leaves.push_back({{corner.x + cell.x, corner.y + cell.y},
                          static_cast<std::uint8_t>(level),
                          states.at(place)});
    }
}

}  // namespace quadcut
