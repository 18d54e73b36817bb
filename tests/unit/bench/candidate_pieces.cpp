// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/candidate_pieces.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"

namespace quadcut {
namespace {

TEST(CandidatePieces, AreWhatTheRoomsOfTheMapAreUnionsOf) {
    sim::BuildingOptions building;
    building.seed = 3;
    building.num_rooms = 8;
    building.furniture = 0.5;
    const GridMap map = sim::generate_building(building).map;
    const CandidatePieces pieces = candidate_pieces(map, {});
    const Segmentation rooms = segment(map);
    std::map<std::uint32_t, std::uint32_t> joined_of_finest;
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> rooms_of_joined;
    std::size_t num_labelled = 0;
    std::size_t num_without_piece = 0;
    for (std::size_t i = 0; i < rooms.labels.values.size(); ++i) {
        const std::uint32_t finest = pieces.finest.values[i];
        const std::uint32_t joined = pieces.joined.values[i];
        EXPECT_EQ(finest == 0, joined == 0);
        if (finest != 0) {
            EXPECT_EQ(joined_of_finest.emplace(finest, joined).first->second, joined);
        }
        if (rooms.labels.values[i] == 0) continue;
        ++num_labelled;
        if (joined == 0) ++num_without_piece;
        ++rooms_of_joined[joined][rooms.labels.values[i]];
    }
    std::set<std::uint32_t> joined;
    for (const auto& [finest, other] : joined_of_finest) joined.insert(other);
    EXPECT_LT(joined.size(), joined_of_finest.size());
    EXPECT_GE(joined.size(), rooms.rooms.size());
    EXPECT_LT(50 * num_without_piece, num_labelled);
    // Slivers change hands after fusing, no more.
    std::size_t num_elsewhere = 0;
    for (const auto& [piece, counts] : rooms_of_joined) {
        std::size_t sum = 0;
        std::size_t most = 0;
        for (const auto& [room, count] : counts) {
            sum += count;
            most = std::max(most, count);
        }
        num_elsewhere += sum - most;
    }
    EXPECT_LT(50 * num_elsewhere, num_labelled);
}

}  // namespace
}  // namespace quadcut
