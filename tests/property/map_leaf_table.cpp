// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/map/occupancy_map.hpp"

// The leaf table against a search through the list of leaves.
namespace quadcut {
namespace {

class LeafTables : public testing::TestWithParam<std::uint64_t> {
protected:
    [[nodiscard]] std::int32_t pick(std::int32_t low, std::int32_t high) {
        return low +
               static_cast<std::int32_t>(random_.below(static_cast<std::uint64_t>(high - low + 1)));
    }
    [[nodiscard]] OccupancyMap random_map() {
        OccupancyMap map(0.05);
        for (int i = 0; i < 30; ++i) {
            const Cell low{pick(-80, 40), pick(-60, 60)};
            const Cell size{pick(1, 40), pick(1, 40)};
            const auto state = static_cast<CellState>(pick(0, 2));
            for (std::int32_t y = 0; y < size.y; ++y) {
                for (std::int32_t x = 0; x < size.x; ++x) {
                    map.set_state({low.x + x, low.y + y}, state);
                }
            }
        }
        map.commit();
        return map;
    }

    Random random_{GetParam()};
};

bool share_a_cell(const Leaf& leaf, Cell low, Cell high) {
    return leaf.lower_left.x <= high.x && leaf.lower_left.y <= high.y &&
           leaf.lower_left.x + leaf.side_cells() > low.x &&
           leaf.lower_left.y + leaf.side_cells() > low.y;
}

TEST_P(LeafTables, FindTheLeafOfEveryCell) {
    const OccupancyMap map = random_map();
    const LeafTable table(map.leaves(), map.root());
    for (std::int32_t y = -80; y < 120; ++y) {
        for (std::int32_t x = -100; x < 100; ++x) {
            const Cell cell{x, y};
            const std::optional<LeafId> found = table.find(cell);
            ASSERT_EQ(found.has_value(), map.state(cell) != CellState::unknown);
            if (found) {
                ASSERT_TRUE(share_a_cell(table.leaf(*found), cell, cell));
                ASSERT_EQ(table.leaf(*found).state, map.state(cell));
            }
        }
    }
}

TEST_P(LeafTables, VisitEachLeafOfARectangleOnce) {
    const OccupancyMap map = random_map();
    const LeafTable table(map.leaves(), map.root());
    for (int i = 0; i < 200; ++i) {
        const Cell low{pick(-100, 90), pick(-90, 110)};
        const Cell high{low.x + pick(-1, 60), low.y + pick(-1, 60)};
        std::vector<std::size_t> wanted;
        for (std::size_t id = 0; id < table.leaves().size(); ++id) {
            const Leaf& leaf = table.leaves()[id];
            if (low.x <= high.x && low.y <= high.y && leaf.state != CellState::unknown &&
                share_a_cell(leaf, low, high)) {
                wanted.push_back(id);
            }
        }
        std::vector<std::size_t> visited;
        table.for_each_leaf_in(low, high, [&](LeafId id) { visited.push_back(index(id)); });
        std::sort(visited.begin(), visited.end());
        ASSERT_EQ(visited, wanted);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, LeafTables, testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace quadcut
