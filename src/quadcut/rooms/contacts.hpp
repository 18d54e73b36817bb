// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {

/// Where two regions touch: the cell of the region with the smaller label comes first.
struct Contact {
    Cell a;
    Cell b;
};

/// Calls `add(map[{a, b}], contact)` for all pairs of cells beside each other whose labels a < b
/// differ and are not 0, row by row; a map for each part of the raster, in their order. O(cells).
template <typename MapByPair, typename Add>
[[nodiscard]] std::vector<MapByPair> for_each_contact(const Raster<std::uint32_t>& labels,
                                                      const Executor& executor, const Add& add) {
    const auto width = static_cast<std::size_t>(labels.width);
    const auto height = static_cast<std::size_t>(labels.height);
    const std::size_t num_rows = rows_per_part(height);
    std::vector<MapByPair> parts((height + num_rows - 1) / num_rows);
    parallel_for(executor, height, num_rows, [&](std::size_t first, std::size_t last) {
        MapByPair& part = parts[first / num_rows];
        // Most contacts are of the same two regions as the one before.
        auto recent = part.end();
        const auto meet = [&](std::size_t i, std::size_t j) {
            if (labels.values[i] > labels.values[j]) std::swap(i, j);
            const std::pair key{labels.values[i], labels.values[j]};
            if (recent == part.end() || recent->first != key) recent = part.try_emplace(key).first;
            add(recent->second, Contact{labels.cell(i), labels.cell(j)});
        };
        const std::uint32_t* const label = labels.values.data();
        for (std::size_t y = first; y < last; ++y) {
            const bool has_above = y + 1 < height;
            for (std::size_t x = 0, i = y * width; x < width; ++x, ++i) {
                const std::uint32_t own = label[i];
                if (own == 0) continue;
                const std::uint32_t right = x + 1 < width ? label[i + 1] : own;
                const std::uint32_t above = has_above ? label[i + width] : own;
                if (right != own && right != 0) meet(i, i + 1);
                if (above != own && above != 0) meet(i, i + width);
            }
        }
    });
    return parts;
}

}  // namespace quadcut
