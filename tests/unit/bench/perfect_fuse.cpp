// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/perfect_fuse.hpp"

#include <initializer_list>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

Raster<std::uint32_t> row_of(std::initializer_list<std::uint32_t> labels) {
    Raster<std::uint32_t> row({0, 0}, static_cast<std::int32_t>(labels.size()), 1);
    std::copy(labels.begin(), labels.end(), row.values.begin());
    return row;
}

TEST(PerfectFuse, GivesEachPieceToTheRoomThatHasMostOfIt) {
    const auto rooms = fused_by_truth(row_of({7, 7, 7, 9, 9, 0, 4, 4}),  //
                                      row_of({1, 1, 2, 2, 2, 2, 3, 0}));
    // Two of three; all; no piece; a tie between the void and a room goes to the smaller number.
    EXPECT_EQ(rooms.values, row_of({1, 1, 1, 2, 2, 0, 0, 0}).values);
}

TEST(PerfectFuse, JoinsPiecesOfOneRoomAndLeavesTheVoid) {
    const auto rooms = fused_by_truth(row_of({1, 2, 3, 4, 4, 4}), row_of({5, 5, 5, 0, 0, 5}));
    EXPECT_EQ(rooms.values, row_of({5, 5, 5, 0, 0, 0}).values);
}

TEST(CutByTruth, CutsAllTrueBordersAndKeepsTheRest) {
    const auto parts = cut_by_truth(row_of({1, 1, 2, 2, 2, 0, 1}), row_of({4, 5, 5, 5, 0, 5, 4}));
    EXPECT_EQ(parts.values, row_of({1, 2, 3, 3, 0, 0, 1}).values);
}

}  // namespace
}  // namespace quadcut
