// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/eigengap.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(Eigengap, RatiosOfNeighbours) {
    const std::vector<double> gaps = relative_gaps(std::vector<double>{0.0, 1e-17, 0.1, 0.2, 1.0});
    ASSERT_EQ(gaps.size(), 4U);
    EXPECT_EQ(gaps[0], 1.0);
    EXPECT_TRUE(std::isinf(gaps[1]));
    EXPECT_DOUBLE_EQ(gaps[2], 2.0);
    EXPECT_DOUBLE_EQ(gaps[3], 5.0);
    EXPECT_TRUE(relative_gaps({}).empty());
}

TEST(Eigengap, NumberBehindTheLargestOne) {
    const std::vector<double> values{0.0, 0.01, 0.02, 0.5, 0.6, 1.0};
    EXPECT_EQ(num_clusters_by_eigengap(values, 2, 5), 3U);
    EXPECT_EQ(num_clusters_by_eigengap(values, 2, 2), 2U);
    EXPECT_EQ(num_clusters_by_eigengap(values, 4, 5), 5U);
}

TEST(Eigengap, EachComponentIsACluster) {
    EXPECT_EQ(num_clusters_by_eigengap(std::vector<double>{0.0, 0.0, 0.0, 0.3, 0.4}, 2, 4), 3U);
}

TEST(Eigengap, OneWhereThereIsNoChoice) {
    EXPECT_EQ(num_clusters_by_eigengap(std::vector<double>{0.0, 0.5}, 2, 9), 1U);
    EXPECT_EQ(num_clusters_by_eigengap({}, 2, 9), 1U);
}

}  // namespace
}  // namespace quadcut
