// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/hungarian.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut::eval {
namespace {

double cost_of(const std::vector<Assignment>& assignment, const std::vector<double>& costs,
               std::size_t num_columns) {
    double sum = 0.0;
    for (const Assignment& pair : assignment) sum += costs[pair.row * num_columns + pair.column];
    return sum;
}

/// The least cost by trying everything.
double least_cost(const std::vector<double>& costs, std::size_t num_rows, std::size_t num_columns) {
    std::vector<std::size_t> order(std::max(num_rows, num_columns));
    std::iota(order.begin(), order.end(), 0);
    double least = std::numeric_limits<double>::infinity();
    do {
        double sum = 0.0;
        for (std::size_t i = 0; i < std::min(num_rows, num_columns); ++i) {
            const std::size_t row = num_rows <= num_columns ? i : order[i];
            const std::size_t column = num_rows <= num_columns ? order[i] : i;
            sum += costs[row * num_columns + column];
        }
        least = std::min(least, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

TEST(Assignment, IsTheCheapestOfAll) {
    Random random(1);
    for (int round = 0; round < 300; ++round) {
        const std::size_t num_rows = 1 + random.below(6);
        const std::size_t num_columns = 1 + random.below(6);
        std::vector<double> costs(num_rows * num_columns);
        // Whole numbers: many assignments tie.
        for (double& cost : costs) cost = -static_cast<double>(random.below(5));
        const std::vector<Assignment> found = assign_least_cost(costs, num_rows, num_columns);
        ASSERT_EQ(found.size(), std::min(num_rows, num_columns));
        EXPECT_DOUBLE_EQ(cost_of(found, costs, num_columns),
                         least_cost(costs, num_rows, num_columns));
        std::vector<bool> is_taken(num_columns, false);
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_TRUE(i == 0 || found[i - 1].row < found[i].row);
            EXPECT_FALSE(is_taken[found[i].column]);
            is_taken[found[i].column] = true;
        }
    }
}

TEST(Assignment, OfEqualCostsIsTheIdentity) {
    const std::vector<double> costs(12, 1.0);
    const std::vector<Assignment> expected = {{0, 0}, {1, 1}, {2, 2}};
    EXPECT_EQ(assign_least_cost(costs, 3, 4), expected);
    EXPECT_EQ(assign_least_cost(costs, 4, 3), expected);
}

TEST(Assignment, OfNothingIsEmpty) {
    EXPECT_TRUE(assign_least_cost({}, 0, 5).empty());
    EXPECT_TRUE(assign_least_cost({}, 0, 0).empty());
}

TEST(Assignment, RefusesAMatrixThatIsNotFull) {
    const std::vector<double> costs(5, 1.0);
    EXPECT_THROW((void)assign_least_cost(costs, 2, 3), std::logic_error);
}

}  // namespace
}  // namespace quadcut::eval
