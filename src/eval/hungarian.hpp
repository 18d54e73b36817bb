// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace quadcut::eval {

/// A row matched with a column.
struct Assignment {
    std::size_t row = 0;
    std::size_t column = 0;
    friend bool operator==(const Assignment&, const Assignment&) = default;
};

/// Matches min(num_rows, num_columns) rows and columns, each at most once, so that the sum of
/// costs[row * num_columns + column] is least. Ascending by row. Shortest augmenting paths
/// (Jonker and Volgenant 1987, for rectangles as in Crouse 2016), O(min^2 * max). Of several best
/// assignments it returns the one scipy.optimize.linear_sum_assignment does: of equally near
/// columns a free one wins, and among those the last one looked at.
/// @pre every cost is finite and costs.size() == num_rows * num_columns.
[[nodiscard]] std::vector<Assignment> assign_least_cost(std::span<const double> costs,
                                                        std::size_t num_rows,
                                                        std::size_t num_columns);

}  // namespace quadcut::eval
