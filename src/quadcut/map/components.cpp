// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/components.hpp"

#include <algorithm>

namespace quadcut {
namespace {

/// A building fills at least this much of the ground around it; less are things inside of one.
constexpr double kMinBuildingShare = 0.05;

// Union-find of labels from 1 on. A label's parent is itself or smaller, so that the top of a set
// is the label that came first.
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
    // For each label, the number of its set from 1 on.
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

}  // namespace

FreeComponents find_free_components(const Raster<CellState>& states) {
    FreeComponents free{{states.origin, states.width, states.height}, {}};
    std::uint32_t* label = free.labels.values.data();
    LabelSets sets;
    for (std::int32_t y = 0; y < states.height; ++y) {
        for (std::int32_t x = 0; x < states.width; ++x, ++label) {
            if (states.values[label - free.labels.values.data()] != CellState::free) continue;
            const std::uint32_t left = x > 0 ? label[-1] : 0;
            const std::uint32_t below = y > 0 ? label[-states.width] : 0;
            *label = left != 0 ? left : below != 0 ? below : sets.add();
            if (below != 0 && below != *label) sets.join(below, *label);
        }
    }
    const std::vector<std::uint32_t> numbers = sets.numbers();
    free.components.resize(*std::max_element(numbers.begin(), numbers.end()));
    label = free.labels.values.data();
    for (std::int32_t y = 0; y < states.height; ++y) {
        const bool is_edge_row = y == 0 || y == states.height - 1;
        for (std::int32_t x = 0; x < states.width; ++x, ++label) {
            *label = numbers[*label];
            if (*label == 0) continue;
            FreeComponents::Component& component = free.components[*label - 1];
            ++component.num_cells;
            if (is_edge_row || x == 0 || x == states.width - 1) ++component.num_border_cells;
        }
    }
    return free;
}

std::optional<std::size_t> find_outside(const FreeComponents& free, std::size_t min_cells) {
    const auto width = static_cast<std::size_t>(free.labels.width);
    const auto height = static_cast<std::size_t>(free.labels.height);
    const std::size_t border =
        width < 2 || height < 2 ? width * height : 2 * width + 2 * height - 4;
    std::optional<std::size_t> outside;
    std::size_t num_others = 0;
    for (std::size_t i = 0; i < free.components.size(); ++i) {
        if (2 * free.components[i].num_border_cells > border) {
            outside = i;
        } else if (free.components[i].num_cells >= min_cells) {
            num_others += free.components[i].num_cells;
        }
    }
    const bool is_building =
        outside && static_cast<double>(num_others) <
                       kMinBuildingShare * static_cast<double>(free.components[*outside].num_cells);
    return is_building ? std::nullopt : outside;
}

std::vector<bool> components_with(const FreeComponents& free, std::span<const Cell> cells) {
    std::vector<bool> found(free.components.size(), false);
    for (const Cell& cell : cells) {
        const std::uint32_t label = free.labels.contains(cell) ? free.labels.at(cell) : 0;
        if (label != 0) found[label - 1] = true;
    }
    return found;
}

Raster<std::uint8_t> mask_of(const FreeComponents& free, const std::vector<bool>& kept) {
    Raster<std::uint8_t> mask(free.labels.origin, free.labels.width, free.labels.height);
    std::transform(free.labels.values.begin(), free.labels.values.end(), mask.values.begin(),
                   [&](std::uint32_t label) {
                       return label != 0 && kept[label - 1] ? std::uint8_t{1} : std::uint8_t{0};
                   });
    return mask;
}

}  // namespace quadcut
