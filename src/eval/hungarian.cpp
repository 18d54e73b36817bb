// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/hungarian.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace quadcut::eval {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The matching as it grows, one row at a time. @pre no more rows than columns.
class Matching {
public:
    Matching(std::span<const double> costs, std::size_t num_rows, std::size_t num_columns)
        : costs_(costs),
          num_columns_(num_columns),
          row_price_(num_rows, 0.0),
          column_price_(num_columns, 0.0),
          column_of_row_(num_rows, kNone),
          row_of_column_(num_columns, kNone),
          distance_(num_columns),
          previous_row_(num_columns) {}

    void add(std::size_t new_row) {
        const std::size_t free_column = find_nearest_free_column(new_row);
        update_prices(new_row);
        augment(new_row, free_column);
    }

    [[nodiscard]] const std::vector<std::size_t>& column_of_row() const { return column_of_row_; }

private:
    /// Dijkstra over reduced costs: distance_ to every column that was settled or seen.
    std::size_t find_nearest_free_column(std::size_t new_row) {
        std::fill(distance_.begin(), distance_.end(), std::numeric_limits<double>::infinity());
        settled_.clear();
        // Last column first: the order decides between equally good assignments.
        open_.resize(num_columns_);
        for (std::size_t i = 0; i < num_columns_; ++i) open_[i] = num_columns_ - 1 - i;

        length_ = 0.0;
        std::size_t row = new_row;
        while (true) {
            const std::size_t nearest = relax(row);
            const std::size_t column = open_[nearest];
            length_ = distance_[column];
            settled_.push_back(column);
            open_[nearest] = open_.back();
            open_.pop_back();
            if (row_of_column_[column] == kNone) return column;
            row = row_of_column_[column];
        }
    }

    /// Looks along all edges of `row`; returns the place in open_ of the column that is nearest
    /// now.
    std::size_t relax(std::size_t row) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const std::size_t column = open_[i];
            const double through = length_ + costs_[row * num_columns_ + column] - row_price_[row] -
                                   column_price_[column];
            if (through < distance_[column]) {
                distance_[column] = through;
                previous_row_[column] = row;
            }
            const double here = distance_[column];
            if (here < least || (here == least && row_of_column_[column] == kNone)) {
                least = here;
                nearest = i;
            }
        }
        return nearest;
    }

    void update_prices(std::size_t new_row) {
        row_price_[new_row] += length_;
        for (const std::size_t column : settled_) {
            const double slack = length_ - distance_[column];
            column_price_[column] -= slack;
            // The free column at the end of the path has no row yet.
            if (row_of_column_[column] != kNone) row_price_[row_of_column_[column]] += slack;
        }
    }

    void augment(std::size_t new_row, std::size_t free_column) {
        std::size_t column = free_column;
        std::size_t row = kNone;
        while (row != new_row) {
            row = previous_row_[column];
            row_of_column_[column] = row;
            std::swap(column_of_row_[row], column);
        }
    }

    std::span<const double> costs_;
    std::size_t num_columns_;
    std::vector<double> row_price_;
    std::vector<double> column_price_;
    std::vector<std::size_t> column_of_row_;
    std::vector<std::size_t> row_of_column_;

    // The path search of the row that is being added.
    std::vector<double> distance_;
    std::vector<std::size_t> previous_row_;
    std::vector<std::size_t> settled_;
    std::vector<std::size_t> open_;
    double length_ = 0.0;
};

std::vector<double> transposed(std::span<const double> costs, std::size_t num_rows,
                               std::size_t num_columns) {
    std::vector<double> result(costs.size());
    for (std::size_t row = 0; row < num_rows; ++row) {
        for (std::size_t column = 0; column < num_columns; ++column) {
            result[column * num_rows + row] = costs[row * num_columns + column];
        }
    }
    return result;
}

}  // namespace

std::vector<Assignment> assign_least_cost(std::span<const double> costs, std::size_t num_rows,
                                          std::size_t num_columns) {
    if (costs.size() != num_rows * num_columns) {
        throw std::logic_error("assign_least_cost: costs do not fill the matrix");
    }
    const bool tall = num_rows > num_columns;
    std::vector<double> turned;
    if (tall) {
        turned = transposed(costs, num_rows, num_columns);
        costs = turned;
        std::swap(num_rows, num_columns);
    }

    Matching matching(costs, num_rows, num_columns);
    for (std::size_t row = 0; row < num_rows; ++row) matching.add(row);

    std::vector<Assignment> result;
    result.reserve(num_rows);
    for (std::size_t row = 0; row < num_rows; ++row) {
        const std::size_t column = matching.column_of_row()[row];
        result.push_back(tall ? Assignment{column, row} : Assignment{row, column});
    }
    std::sort(result.begin(), result.end(),
              [](const Assignment& a, const Assignment& b) { return a.row < b.row; });
    return result;
}

}  // namespace quadcut::eval
