// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The connected parts (4 neighbours) of a set of cells.
struct ConnectedParts {
    /// 0: not in the set; else the number of the part, in the order of their first cells, row by
    /// row.
    Raster<std::uint32_t> labels;
    std::uint32_t count = 0;

    /// The number of cells of each part; those of no part come first.
    [[nodiscard]] std::vector<std::size_t> num_cells() const {
        std::vector<std::size_t> result(count + std::size_t{1}, 0);
        for (const std::uint32_t label : labels.values) ++result[label];
        return result;
    }
    /// The offsets of the cells, ascending, of each part that is `wanted`; of others none.
    [[nodiscard]] std::vector<std::vector<std::size_t>> cells_of(
        const std::vector<bool>& wanted) const {
        std::vector<std::vector<std::size_t>> result(count + std::size_t{1});
        for (std::size_t i = 0; i < labels.values.size(); ++i) {
            if (wanted[labels.values[i]]) result[labels.values[i]].push_back(i);
        }
        return result;
    }
};

/// Union-find of labels from 1 on. A label's parent is itself or smaller, so that the top of a set
/// is the label that came first.
class LabelSets {
public:
    std::uint32_t add() {
        parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
        return parents_.back();
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = top_of(a);
        b = top_of(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }
    /// For each label, the number of its set from 1 on.
    [[nodiscard]] std::vector<std::uint32_t> numbers() const {
        std::vector<std::uint32_t> numbers(parents_.size(), 0);
        std::uint32_t num_sets = 0;
        for (std::uint32_t label = 1; label < numbers.size(); ++label) {
            const std::uint32_t parent = parents_[label];
            numbers[label] = parent == label ? ++num_sets : numbers[parent];
        }
        return numbers;
    }

private:
    std::uint32_t top_of(std::uint32_t label) {
        while (parents_[label] != label) label = parents_[label] = parents_[parents_[label]];
        return label;
    }

    std::vector<std::uint32_t> parents_{0};
};

/// The parts of the cells for whose offset `is_in(offset)` holds; neighbours are in one part when
/// `is_same(offset, offset)`. Two passes over rows. O(cells).
template <typename T, typename IsIn, typename IsSame>
[[nodiscard]] ConnectedParts connected_parts(const Raster<T>& raster, const IsIn& is_in,
                                             const IsSame& is_same) {
    ConnectedParts parts{{raster.origin, raster.width, raster.height}, 0};
    const auto width = static_cast<std::size_t>(raster.width);
    std::vector<std::uint32_t>& labels = parts.labels.values;
    LabelSets sets;
    for (std::size_t row = 0; row < labels.size(); row += width) {
        for (std::size_t i = row; i < row + width; ++i) {
            if (!is_in(i)) continue;
            const std::uint32_t left = i > row && is_same(i - 1, i) ? labels[i - 1] : 0;
            const std::uint32_t below = row > 0 && is_same(i - width, i) ? labels[i - width] : 0;
            labels[i] = left != 0 ? left : below != 0 ? below : sets.add();
            if (below != 0 && below != labels[i]) sets.join(below, labels[i]);
        }
    }
    const std::vector<std::uint32_t> numbers = sets.numbers();
    parts.count = *std::max_element(numbers.begin(), numbers.end());
    for (std::uint32_t& label : labels) label = numbers[label];
    return parts;
}

}  // namespace quadcut
