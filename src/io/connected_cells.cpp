// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/connected_cells.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace quadcut::io {
namespace {

/// Joins numbers that turn out to mean the same region (union-find with path halving).
class RegionNumbers {
public:
    std::uint32_t add() {
        constexpr std::uint32_t kMost = std::uint32_t{1} << 31U;
        if (parent_.size() >= kMost) throw std::logic_error("number_connected: too many regions");
        parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
        return parent_.back();
    }
    std::uint32_t find(std::uint32_t number) {
        while (parent_[number] != number) {
            parent_[number] = parent_[parent_[number]];
            number = parent_[number];
        }
        return number;
    }
    /// The older number stays: regions keep the order of their first cells.
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    [[nodiscard]] std::size_t size() const { return parent_.size(); }

private:
    std::vector<std::uint32_t> parent_{0};
};

/// The first pass: replaces values by numbers that are still to be joined; returns the value of
/// each number.
std::vector<std::uint32_t> number_provisionally(Raster<std::uint32_t>& cells,
                                                std::uint32_t diagonal_value,
                                                RegionNumbers& numbers) {
    const auto width = static_cast<std::size_t>(cells.width);
    std::vector<std::uint32_t> value_of{0};
    std::vector<std::uint32_t> row_below(width);  // The values that were there.
    std::vector<std::uint32_t> row_values(width);
    for (std::size_t begin = 0; begin < cells.values.size(); begin += width) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint32_t value = cells.values[begin + x];
            row_values[x] = value;
            if (value == 0) continue;
            std::uint32_t number = 0;
            const auto join = [&](bool same_value, std::size_t neighbour) {
                if (!same_value) return;
                const std::uint32_t other = cells.values[neighbour];
                if (number != 0 && number != other) numbers.join(number, other);
                number = other;
            };
            join(x > 0 && row_values[x - 1] == value, begin + x - 1);
            if (begin > 0) {
                const bool diagonal = value == diagonal_value;
                join(diagonal && x > 0 && row_below[x - 1] == value, begin + x - width - 1);
                join(diagonal && x + 1 < width && row_below[x + 1] == value, begin + x - width + 1);
                join(row_below[x] == value, begin + x - width);
            }
            if (number == 0) {
                number = numbers.add();
                value_of.push_back(value);
            }
            cells.values[begin + x] = number;
        }
        row_below.swap(row_values);
    }
    return value_of;
}

}  // namespace

CellRegions number_connected(Raster<std::uint32_t> values, std::uint32_t diagonal_value) {
    CellRegions regions;
    regions.numbers = std::move(values);
    RegionNumbers numbers;
    const std::vector<std::uint32_t> value_of =
        number_provisionally(regions.numbers, diagonal_value, numbers);

    std::vector<std::uint32_t> final_number(numbers.size());
    for (std::uint32_t number = 1; number < numbers.size(); ++number) {
        const std::uint32_t root = numbers.find(number);
        if (root == number) {
            regions.values.push_back(value_of[number]);
            final_number[number] = static_cast<std::uint32_t>(regions.values.size());
        } else {
            final_number[number] = final_number[root];
        }
    }
    regions.num_cells.resize(regions.values.size());
    for (std::uint32_t& cell : regions.numbers.values) {
        cell = final_number[cell];
        if (cell > 0) ++regions.num_cells[cell - 1];
    }
    return regions;
}

}  // namespace quadcut::io
