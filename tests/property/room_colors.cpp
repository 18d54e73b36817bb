// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/palette.hpp"
#include "quadcut/base/random.hpp"

namespace quadcut::io {
namespace {

struct RoomGraph {
    std::vector<RoomKind> kinds;
    std::vector<RoomPair> pairs;
};

/// Rooms on a grid that touch their neighbours, some across a wall only, and corridors that touch
/// whole rows of them.
RoomGraph random_graph(Random& random) {
    constexpr std::uint32_t kSide = 9;
    RoomGraph graph;
    std::set<std::pair<std::uint16_t, std::uint16_t>> joined;
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        const auto low = static_cast<std::uint16_t>(std::min(a, b) + 1);
        const auto high = static_cast<std::uint16_t>(std::max(a, b) + 1);
        if (a == b || !joined.emplace(low, high).second) return;
        graph.pairs.push_back(
            {low, high, random.below(2) == 0 ? Closeness::touching : Closeness::across_wall});
    };
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        graph.kinds.push_back(random.below(4) == 0 ? RoomKind::corridor : RoomKind::room);
        if (i % kSide > 0 && random.uniform() < 0.9) join(i, i - 1);
        if (i >= kSide && random.uniform() < 0.9) join(i, i - kSide);
        if (i % kSide > 0 && i >= kSide && random.uniform() < 0.5) join(i, i - kSide - 1);
    }
    for (std::uint32_t row = 0; row < kSide; row += 3) {
        const auto corridor = static_cast<std::uint32_t>(graph.kinds.size());
        graph.kinds.push_back(RoomKind::corridor);
        for (std::uint32_t x = 0; x < kSide; ++x) join(corridor, row * kSide + x);
    }
    return graph;
}

TEST(RoomColorsProperty, NeighboursAreClearlyDifferent) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const RoomGraph graph = random_graph(random);
        const auto colors = choose_room_colors(graph.kinds, graph.pairs);
        ASSERT_EQ(colors.size(), graph.kinds.size());
        for (const RoomPair& pair : graph.pairs) {
            EXPECT_GE(perceived_distance(colors[pair.a - 1U], colors[pair.b - 1U]), kClearDistance)
                << "seed " << seed << ", rooms " << pair.a << " and " << pair.b;
        }
        EXPECT_EQ(choose_room_colors(graph.kinds, graph.pairs), colors);
    }
}

}  // namespace
}  // namespace quadcut::io
