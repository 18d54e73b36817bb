// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/map/raster.hpp"

namespace quadcut {

enum class Connectivity : std::uint8_t { four = 4, eight = 8 };

/// Offsets of the cells around `cell` that lie in the raster.
template <typename T>
struct Neighbours {
    std::array<std::size_t, 8> offsets{};
    std::size_t count = 0;

    Neighbours(const Raster<T>& raster, std::size_t cell, Connectivity connectivity) {
        const auto width = static_cast<std::size_t>(raster.width);
        const std::size_t x = cell % width;
        const bool left = x > 0;
        const bool right = x + 1 < width;
        const bool below = cell >= width;
        const bool above = cell + width < raster.values.size();
        const auto add = [&](bool inside, std::size_t offset) {
            if (inside) offsets[count++] = offset;
        };
        add(left, cell - 1);
        add(right, cell + 1);
        add(below, cell - width);
        add(above, cell + width);
        if (connectivity == Connectivity::four) return;
        add(left && below, cell - width - 1);
        add(right && below, cell - width + 1);
        add(left && above, cell + width - 1);
        add(right && above, cell + width + 1);
    }
    [[nodiscard]] const std::size_t* begin() const { return offsets.data(); }
    [[nodiscard]] const std::size_t* end() const { return offsets.data() + count; }
};

/// The cells connected to `seed` for which `belongs(offset)` holds, seed first; marks them in
/// `seen`, and passes over what is marked already. O(cells found).
template <typename T, typename Predicate>
[[nodiscard]] std::vector<std::size_t> flood(const Raster<T>& raster, std::size_t seed,
                                             std::vector<bool>& seen, Connectivity connectivity,
                                             const Predicate& belongs) {
    std::vector<std::size_t> cells{seed};
    seen[seed] = true;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const std::size_t next : Neighbours(raster, cells[i], connectivity)) {
            if (seen[next] || !belongs(next)) continue;
            seen[next] = true;
            cells.push_back(next);
        }
    }
    return cells;
}

/// Whether a cell lies on the edge of the raster.
template <typename T>
[[nodiscard]] bool is_on_edge(const Raster<T>& raster, std::size_t cell) {
    const auto width = static_cast<std::size_t>(raster.width);
    return cell % width == 0 || (cell + 1) % width == 0 || cell < width ||
           cell + width >= raster.values.size();
}

}  // namespace quadcut
