// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/judge.hpp"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::reproduce {
namespace {

// Numbers of a run in which all is as the paper says; each test spoils one after the other.

ByWorld both(double value) { return {{"A", value}, {"B", value}}; }
/// One world spoilt is enough.
ByWorld one_of_two(double good, double bad) { return {{"A", good}, {"B", bad}}; }

std::set<std::size_t> differing(const std::vector<Claim>& claims) {
    std::set<std::size_t> places;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        EXPECT_FALSE(claims[i].reason.empty()) << claims[i].quantity;
        if (!holds(claims[i])) places.insert(i);
    }
    return places;
}

/// All of the paper's claims hold; after `spoil` those do not.
template <typename Numbers, typename Spoil>
void expect_red(Numbers numbers, const std::set<std::size_t>& places, const Spoil& spoil) {
    EXPECT_EQ(differing(judge(numbers)), std::set<std::size_t>{});
    spoil(numbers);
    EXPECT_EQ(differing(judge(numbers)), places);
}

TEST(Judge, Figure4) {
    using Numbers = StorageNumbers;
    const Numbers good{both(0.8), both(20.0), both(0.9), 0.2};
    expect_red(good, {0}, [](Numbers& n) { n.build_ratio = one_of_two(0.8, 1.1); });
    expect_red(good, {1}, [](Numbers& n) { n.node_percent = one_of_two(20.0, 101.0); });
    expect_red(good, {2}, [](Numbers& n) { n.look_up_ratio = one_of_two(0.9, 1.4); });
    expect_red(good, {3}, [](Numbers& n) { n.finest_over_coarsest = 1.0; });
}

TEST(Judge, Figure6) {
    using Numbers = MatrixNumbers;
    const Numbers good{1.4, 2.2, 0.4};
    expect_red(good, {0}, [](Numbers& n) { n.entries_percent = 10.0; });
    expect_red(good, {1}, [](Numbers& n) { n.csr_percent = 15.0; });
    expect_red(good, {2}, [](Numbers& n) { n.dia_percent = 62.0; });
}

TEST(Judge, Figure7) {
    using Numbers = ThreadNumbers;
    const Numbers good{2, 1.6, 1.2};
    expect_red(good, {0}, [](Numbers& n) { n.speed_up = 1.4; });
    expect_red(good, {0}, [](Numbers& n) { n.num_cores = 4; });
    expect_red(good, {1}, [](Numbers& n) { n.most_over_best = 1.0; });
}

TEST(Judge, Figure11IsAboutThePapersOwnSetting) {
    using Numbers = WorkplaceNumbers;
    const Numbers good{5.0, 3.0, 90.0, 1.2};
    expect_red(good, {0}, [](Numbers& n) { n.num_inner = 4.0; });
    expect_red(good, {0}, [](Numbers& n) { n.num_inner = 6.0; });
    expect_red(good, {1}, [](Numbers& n) { n.num_outer = 1.0; });
    expect_red(good, {2}, [](Numbers& n) { n.pq_percent = 46.8; });
    expect_red(good, {3}, [](Numbers& n) { n.coupling_ratio = 3.0; });
}

TEST(Judge, Figure12) {
    using Numbers = ExplorationNumbers;
    const Numbers good{both(95.0), both(100.0), both(0.0), 5.0};
    expect_red(good, {0}, [](Numbers& n) { n.paper_like_batch = one_of_two(95.0, 35.8); });
    expect_red(good, {1}, [](Numbers& n) { n.rooms_like_batch = one_of_two(95.0, 79.0); });
    expect_red(good, {2}, [](Numbers& n) { n.num_uncrossed = one_of_two(0.0, 1.0); });
    expect_red(good, {3}, [](Numbers& n) { n.num_submaps = 6.0; });
}

TEST(Judge, Figure13) {
    using Numbers = UpdateNumbers;
    const Numbers good{both(100.0), both(60.0), both(3.0), both(5.0), both(8.0)};
    expect_red(good, {0}, [](Numbers& n) { n.ps_crossing = one_of_two(100.0, 80.0); });
    expect_red(good, {1}, [](Numbers& n) { n.percent_below = one_of_two(60.0, 22.4); });
    expect_red(good, {2}, [](Numbers& n) { n.rebuilt_percent = one_of_two(3.0, 26.0); });
    expect_red(good, {3}, [](Numbers& n) { n.tree_over_rebuilt = one_of_two(5.0, 0.9); });
    expect_red(good, {4}, [](Numbers& n) { n.tree_over_scan = one_of_two(8.0, 0.5); });
}

TEST(Judge, Figure14) {
    using Numbers = GrowthNumbers;
    const Numbers good{both(1.3), both(1.1), both(20.0), both(10.0)};
    expect_red(good, {0}, [](Numbers& n) { n.basic_growth = one_of_two(1.3, 1.0); });
    expect_red(good, {1}, [](Numbers& n) { n.update_growth = one_of_two(1.1, 1.3); });
    expect_red(good, {2}, [](Numbers& n) { n.node_percent = one_of_two(20.0, 79.0); });
    expect_red(good, {3}, [](Numbers& n) { n.time_percent = one_of_two(10.0, 90.0); });
}

TEST(Judge, Figures15To17) {
    using Numbers = SubmapNumbers;
    const Numbers good{10,         10.0,
                       {1.0, 1.7}, {0.6, 1.6},
                       {0.0, 3.0}, {3000.0, 100.0},
                       {2.2, 5.3}, {39738.0, 15675.0}};
    expect_red(good, {0}, [](Numbers& n) { n.num_made = 9.0; });
    expect_red(good, {1}, [](Numbers& n) { n.coupling_percent.paper = 3.14; });
    expect_red(good, {2}, [](Numbers& n) { n.cut_percent.paper = 1.61; });
    expect_red(good, {3}, [](Numbers& n) { n.imbalance.paper = 5.4; });
    expect_red(good, {4}, [](Numbers& n) { n.num_broken.paper = 1.0; });
    expect_red(good, {5}, [](Numbers& n) { n.num_broken.other = 0.0; });
    expect_red(good, {6}, [](Numbers& n) { n.elapsed_ms.paper = 90.0; });
    expect_red(good, {7}, [](Numbers& n) { n.num_units.other = 40000.0; });
}

TEST(Judge, Figure18IsAboutQualityToo) {
    using Numbers = IntelNumbers;
    const Numbers good{800.0, 6.0, {80.0, 10.0}, 80.0, {30.0, 5.0}};
    expect_red(good, {0}, [](Numbers& n) { n.whole_ms = 17301.0; });
    expect_red(good, {1, 2}, [](Numbers& n) { n.local_ms = 44.0; });
    expect_red(good, {2}, [](Numbers& n) { n.local_ms = 9.0; });
    expect_red(good, {3}, [](Numbers& n) { n.pq_percent.paper = 20.9; });
    expect_red(good, {3, 5}, [](Numbers& n) { n.pq_percent.paper = 9.0; });
    expect_red(good, {4}, [](Numbers& n) { n.followed_pq_percent = 50.0; });
    expect_red(good, {6}, [](Numbers& n) { n.open_border_percent.paper = 4.0; });
}

TEST(Judge, Figures20To22) {
    using Numbers = LaboratoryNumbers;
    const Numbers good{90.0, 4.0, 80.0, {5.0, 2.0}};
    expect_red(good, {0}, [](Numbers& n) { n.half_like_end_percent = 51.5; });
    expect_red(good, {1}, [](Numbers& n) { n.num_half = 2.0; });
    expect_red(good, {2}, [](Numbers& n) { n.pq_percent = 52.8; });
    // As many as the preset `rooms` cuts are no tables' doing.
    expect_red(good, {3}, [](Numbers& n) { n.num_cut = {2.0, 2.0}; });
}

}  // namespace
}  // namespace quadcut::reproduce
