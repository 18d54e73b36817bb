// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "tests/unit/map/log_odds.hpp"
#include "tests/unit/map/reference_tree.hpp"

// The quadtree map against a plain array of log-odds and a tree built by plain recursion.
namespace quadcut {
namespace {

constexpr std::int32_t kReach = 90;  // writes stay within +- this

class PlainMap {
public:
    [[nodiscard]] int log_odds(Cell cell) const {
        return values_.contains(cell) ? values_.at(cell) : 0;
    }
    void set(Cell cell, CellState state) {
        values_.at(cell) = state == CellState::unknown ? 0
                           : state == CellState::free  ? kMinLogOdds
                                                       : kMaxLogOdds;
    }
    void add(Cell cell, int delta) {
        const int sum = std::clamp(values_.at(cell) + delta, kMinLogOdds, kMaxLogOdds);
        values_.at(cell) = sum != 0 ? sum : delta < 0 ? -1 : 1;
    }

private:
    Raster<int> values_{{-kReach - 8, -kReach - 8}, 2 * kReach + 16, 2 * kReach + 16};
};

test::ReferenceTree tree_of(const OccupancyMap& map) {
    return test::reference_tree(map.root(), [&](Cell cell) { return map.state(cell); });
}

template <typename T>
std::size_t count_missing(const std::vector<T>& wanted, const std::vector<T>& in) {
    return static_cast<std::size_t>(std::count_if(wanted.begin(), wanted.end(), [&](const T& t) {
        return std::find(in.begin(), in.end(), t) == in.end();
    }));
}

// A batch of writes of several kinds around a place that wanders, as a robot does.
class RandomWriter {
public:
    explicit RandomWriter(std::uint64_t seed) : random_(seed) {}

    void write_batch(OccupancyMap& map, PlainMap& plain) {
        place_ = {step(place_.x), step(place_.y)};
        for (int i = pick(6); i >= 0; --i) {
            switch (pick(4)) {
                case 0:
                    fill(map, plain, static_cast<CellState>(pick(3)));
                    break;
                case 1:
                    add_tile(map, plain);
                    break;
                case 2:
                    clear_tile(map, plain);
                    break;
                default:
                    add_cells(map, plain);
            }
        }
    }

private:
    int pick(int count) {
        return static_cast<int>(random_.below(static_cast<std::uint64_t>(count)));
    }
    std::int32_t step(std::int32_t at) {
        return std::clamp(at + pick(61) - 30, -kReach + 30, kReach - 30);
    }
    Cell near() { return {place_.x + pick(25) - 12, place_.y + pick(25) - 12}; }
    int delta() { return pick(2) == 0 ? -1 - pick(3) : 1 + pick(4); }

    void fill(OccupancyMap& map, PlainMap& plain, CellState state) {
        const Cell low = near();
        const Cell size{1 + pick(18), 1 + pick(18)};
        for (std::int32_t y = 0; y < size.y; ++y) {
            for (std::int32_t x = 0; x < size.x; ++x) {
                map.set_state({low.x + x, low.y + y}, state);
                plain.set({low.x + x, low.y + y}, state);
            }
        }
    }
    void add_cells(OccupancyMap& map, PlainMap& plain) {
        const int change = delta();
        for (int i = 0; i < 12; ++i) {
            const Cell cell = near();
            test::add_log_odds(map, cell, change);
            plain.add(cell, change);
        }
    }
    void add_tile(OccupancyMap& map, PlainMap& plain) {
        const Cell cell = near();
        add_tile(map, plain, {cell.x >> 3, cell.y >> 3}, random_.bits() | random_.bits(), delta());
    }
    void clear_tile(OccupancyMap& map, PlainMap& plain) {
        const Cell cell = near();
        for (int i = 0; i < 2; ++i) {
            add_tile(map, plain, {cell.x >> 3, cell.y >> 3}, kWholeTile, -8);
        }
    }
    void add_tile(OccupancyMap& map, PlainMap& plain, Cell tile, std::uint64_t rows, int change) {
        Tile sum = map.tile(tile);
        for (std::size_t i = 0; i < kTileCells; ++i) {
            sum.values[i] = bounded_sum(sum.values[i], (rows >> i & 1) != 0 ? change : 0);
        }
        map.set_tile(tile, sum);
        for (int i = 0; i < 64; ++i) {
            if ((rows >> i & 1) != 0) {
                plain.add({tile.x * 8 + i % 8, tile.y * 8 + i / 8}, change);
            }
        }
    }

    Random random_;
    Cell place_;
};

class MapTree : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MapTree, IsThePlainTreeOfThePlainArrayAfterEveryUpdate) {
    OccupancyMap map(0.05);
    PlainMap plain;
    RandomWriter writer(GetParam());
    test::ReferenceTree before = tree_of(map);
    for (int batch = 0; batch < 40; ++batch) {
        writer.write_batch(map, plain);
        const MapUpdate update = map.commit();

        for (std::int32_t y = -kReach - 9; y <= kReach + 9; ++y) {
            for (std::int32_t x = -kReach - 9; x <= kReach + 9; ++x) {
                ASSERT_EQ(map.log_odds({x, y}), plain.log_odds({x, y})) << x << ' ' << y;
            }
        }
        const test::ReferenceTree after = tree_of(map);
        ASSERT_EQ(map.leaves(), after.leaves);
        ASSERT_EQ(map.num_leaves(), after.leaves.size());
        ASSERT_EQ(map.num_nodes(), after.leaves.size() + after.inner_nodes.size());
        ASSERT_EQ(map.num_nodes_in(map.root()), map.num_nodes());

        ASSERT_EQ(update.nodes_rebuilt, count_missing(after.leaves, before.leaves) +
                                            count_missing(after.inner_nodes, before.inner_nodes));
        before = after;
    }
}

TEST_P(MapTree, OfARasterIsTheTreeOfItsCells) {
    Random random(GetParam());
    GridMap grid{0.05, {}, {}};
    const auto side = [&] { return static_cast<std::int32_t>(1 + random.below(70)); };
    grid.states = Raster<CellState>({0, 0}, side(), side());
    for (int i = 0; i < 12; ++i) {
        const Cell low{side() % grid.states.width, side() % grid.states.height};
        const auto state = static_cast<CellState>(random.below(3));
        for (std::int32_t y = low.y; y < std::min(low.y + 20, grid.states.height); ++y) {
            for (std::int32_t x = low.x; x < std::min(low.x + 20, grid.states.width); ++x) {
                grid.states.at({x, y}) = state;
            }
        }
    }
    const OccupancyMap map = OccupancyMap::from_grid(grid);
    EXPECT_EQ(map.root().lower_left, (Cell{0, 0}));
    for (std::int32_t y = -3; y < grid.states.height + 3; ++y) {
        for (std::int32_t x = -3; x < grid.states.width + 3; ++x) {
            const Cell cell{x, y};
            ASSERT_EQ(map.state(cell),
                      grid.states.contains(cell) ? grid.states.at(cell) : CellState::unknown);
        }
    }
    EXPECT_EQ(map.leaves(), tree_of(map).leaves);
    EXPECT_EQ(map.num_leaves(), map.leaves().size());
    EXPECT_EQ(map.num_nodes_in(map.root()), map.num_nodes());
}

INSTANTIATE_TEST_SUITE_P(Seeds, MapTree, testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace quadcut
