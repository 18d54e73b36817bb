// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "quadcut/map/integrate.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// One int8 a cell over a rectangle that is known beforehand.
class FlatGrid {
public:
    /// All 0. @pre so is `box`.
    explicit FlatGrid(Raster<std::int8_t> box) : cells_(std::move(box)) {}

    [[nodiscard]] int log_odds(Cell cell) const {
        const auto x = static_cast<std::uint32_t>(cell.x - cells_.origin.x);
        const auto y = static_cast<std::uint32_t>(cell.y - cells_.origin.y);
        const auto width = static_cast<std::uint32_t>(cells_.width);
        if (x >= width || y >= static_cast<std::uint32_t>(cells_.height)) return 0;
        return cells_.values[std::size_t{y} * width + x];
    }
    void set(Cell cell, int log_odds) {
        if (cells_.contains(cell)) cells_.at(cell) = static_cast<std::int8_t>(log_odds);
    }
    [[nodiscard]] std::size_t bytes() const { return cells_.values.capacity(); }

private:
    Raster<std::int8_t> cells_;
};

/// The same evidence, scan by scan, into each structure.
template <typename Structure>
void replay(Structure& structure, const std::vector<std::vector<TileEvidence>>& scans) {
    const IntegrateOptions options;
    for (const std::vector<TileEvidence>& scan : scans) {
        for (const TileEvidence& one : scan) {
            for (int i = 0; i < 64; ++i) {
                const bool hit = (one.hit >> i & 1) != 0;
                if (hit || (one.miss >> i & 1) != 0) {
                    const Cell cell{one.tile.x * 8 + i % 8, one.tile.y * 8 + i / 8};
                    const int before = structure.log_odds(cell);
                    const int after{bounded_sum(before, hit ? options.hit : options.miss)};
                    if (after != before) structure.set(cell, after);
                }
            }
        }
    }
}

}  // namespace quadcut
