// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

// Morton (Z-order) codes: bit 2i is bit i of x, bit 2i + 1 is bit i of y. Sorting blocks of one
// size by code is the depth-first order of the quadtree, and code >> 2 is the parent's.

/// The low 32 bits of `value` moved to the even bits.
[[nodiscard]] constexpr std::uint64_t spread_bits(std::uint64_t value) {
    value &= 0xFFFF'FFFFU;
    value = (value | (value << 16)) & 0x0000'FFFF'0000'FFFFU;
    value = (value | (value << 8)) & 0x00FF'00FF'00FF'00FFU;
    value = (value | (value << 4)) & 0x0F0F'0F0F'0F0F'0F0FU;
    value = (value | (value << 2)) & 0x3333'3333'3333'3333U;
    return (value | (value << 1)) & 0x5555'5555'5555'5555U;
}

/// The even bits of `value` gathered into the low 32.
[[nodiscard]] constexpr std::uint32_t gather_bits(std::uint64_t value) {
    value &= 0x5555'5555'5555'5555U;
    value = (value | (value >> 1)) & 0x3333'3333'3333'3333U;
    value = (value | (value >> 2)) & 0x0F0F'0F0F'0F0F'0F0FU;
    value = (value | (value >> 4)) & 0x00FF'00FF'00FF'00FFU;
    value = (value | (value >> 8)) & 0x0000'FFFF'0000'FFFFU;
    return static_cast<std::uint32_t>(value | (value >> 16));
}

/// @pre position.x >= 0 and position.y >= 0.
[[nodiscard]] constexpr std::uint64_t morton_code(Cell position) {
    return spread_bits(static_cast<std::uint32_t>(position.x)) |
           (spread_bits(static_cast<std::uint32_t>(position.y)) << 1);
}

/// By which work at cells is ordered, so that what lies beside each other is done one after the
/// other and found in the cache: the code of the cell's block in the box.
[[nodiscard]] constexpr std::uint64_t block_code(Cell cell, const Box& box) {
    constexpr std::int32_t kBlock = 64;
    return morton_code({(cell.x - box.low.x) / kBlock, (cell.y - box.low.y) / kBlock});
}

[[nodiscard]] constexpr Cell morton_position(std::uint64_t code) {
    return {static_cast<std::int32_t>(gather_bits(code)),
            static_cast<std::int32_t>(gather_bits(code >> 1))};
}

}  // namespace quadcut
