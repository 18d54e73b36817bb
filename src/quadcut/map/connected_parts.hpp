// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Cells beside each other in one row, columns begin .. end - 1, that belong to one part.
struct CellRun {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t part = 0;
};

/// The connected parts of a set of cells, as runs: a tenth of the memory of a raster of labels, or
/// less.
struct ConnectedParts {
    std::int32_t width = 0;
    /// Row by row; those of row y are row_begin[y] .. row_begin[y + 1] - 1.
    std::vector<CellRun> runs;
    std::vector<std::size_t> row_begin{0};
    /// Parts are numbered from 1 in the order of their first cells, row by row.
    std::uint32_t count = 0;

    /// Calls `visit(run, offset of its first cell)` for all runs in order.
    template <typename Visitor>
    void for_each_run(const Visitor& visit) const {
        for (std::size_t y = 0; y + 1 < row_begin.size(); ++y) {
            for (std::size_t i = row_begin[y]; i < row_begin[y + 1]; ++i) {
                visit(runs[i], y * static_cast<std::size_t>(width) + runs[i].begin);
            }
        }
    }
    /// The number of cells of each part; nothing at 0, which is no part.
    [[nodiscard]] std::vector<std::size_t> num_cells() const;
    /// The offsets of the cells, ascending, of each part that is `wanted`, in their order.
    [[nodiscard]] std::vector<std::vector<std::size_t>> cells_of(
        const std::vector<bool>& wanted) const;
    /// `values[part]` in the cells of each part, `values[0]` in all others, into `cells`, a raster
    /// of the same size.
    template <typename T, typename Values>
    void paint(const Values& values, Raster<T>& cells, const Executor& executor = {}) const {
        constexpr std::size_t kRows = 64;
        const auto length = static_cast<std::size_t>(width);
        parallel_for(executor, row_begin.size() - 1, kRows,
                     [&](std::size_t first, std::size_t last) {
                         for (std::size_t y = first; y < last; ++y) {
                             T* const row = cells.values.data() + y * length;
                             std::fill_n(row, length, static_cast<T>(values[0]));
                             for (std::size_t i = row_begin[y]; i < row_begin[y + 1]; ++i) {
                                 std::fill(row + runs[i].begin, row + runs[i].end,
                                           static_cast<T>(values[runs[i].part]));
                             }
                         }
                     });
    }
    /// For each part, whether it has fewer cells than that, and none on the edge of the raster: of
    /// others, more may lie beyond.
    [[nodiscard]] std::vector<bool> islands(double num_cells_of_large) const;
    /// For each part, whether it has cells on the edge of the raster.
    [[nodiscard]] std::vector<bool> on_edge() const;
    /// The part of the cell in this column and row; 0 if none. O(log runs of the row).
    [[nodiscard]] std::uint32_t part_at(std::uint32_t column, std::size_t row) const;
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
    /// For each label, the number of its set from 1 on. The sets are used up.
    [[nodiscard]] std::vector<std::uint32_t> take_numbers() {
        // A parent, which is smaller, is a number already.
        std::uint32_t num_sets = 0;
        for (std::uint32_t label = 1; label < parents_.size(); ++label) {
            const std::uint32_t parent = parents_[label];
            parents_[label] = parent == label ? ++num_sets : parents_[parent];
        }
        return std::move(parents_);
    }

private:
    std::uint32_t top_of(std::uint32_t label) {
        while (parents_[label] != label) label = parents_[label] = parents_[parents_[label]];
        return label;
    }

    std::vector<std::uint32_t> parents_{0};
};

/// Finds the parts of runs whose `part` is a key as yet: those of the same key that touch, in rows
/// that follow each other. O(runs).
[[nodiscard]] ConnectedParts join_runs(ConnectedParts keyed, Connectivity connectivity);

/// The parts of the cells for whose offset `key_of(offset)` is not 0; neighbours with the same key
/// are in one part. Keys are below 2^32. O(cells).
template <typename T, typename KeyOf>
[[nodiscard]] ConnectedParts connected_parts(const Raster<T>& raster, const KeyOf& key_of,
                                             Connectivity connectivity = Connectivity::four,
                                             const Executor& executor = {}) {
    constexpr std::size_t kRowsPerChunk = 32;
    const auto width = static_cast<std::size_t>(raster.width);
    const auto height = static_cast<std::size_t>(raster.height);
    std::vector<ConnectedParts> chunks((height + kRowsPerChunk - 1) / kRowsPerChunk);
    parallel_for(executor, height, kRowsPerChunk, [&](std::size_t first_row, std::size_t last_row) {
        ConnectedParts& found = chunks[first_row / kRowsPerChunk];
        for (std::size_t y = first_row; y < last_row; ++y) {
            const std::size_t row = y * width;
            for (std::size_t x = 0; x < width;) {
                const std::size_t begin = x;
                const auto key = key_of(row + begin);
                while (++x < width && key_of(row + x) == key) {
                }
                if (key == 0) continue;
                found.runs.push_back({static_cast<std::uint32_t>(begin),
                                      static_cast<std::uint32_t>(x),
                                      static_cast<std::uint32_t>(key)});
            }
            found.row_begin.push_back(found.runs.size());
        }
    });
    ConnectedParts all;
    all.width = raster.width;
    std::size_t num_runs = 0;
    for (const ConnectedParts& chunk : chunks) num_runs += chunk.runs.size();
    all.runs.reserve(num_runs);
    for (ConnectedParts& chunk : chunks) {
        const std::size_t before = all.runs.size();
        for (std::size_t y = 1; y < chunk.row_begin.size(); ++y) {
            all.row_begin.push_back(before + chunk.row_begin[y]);
        }
        all.runs.insert(all.runs.end(), chunk.runs.begin(), chunk.runs.end());
        chunk = {};
    }
    return join_runs(std::move(all), connectivity);
}

/// Of the free space, by 4 neighbours. There may be as many as half the cells. O(cells).
[[nodiscard]] ConnectedParts free_parts(const Raster<CellState>& states,
                                        const Executor& executor = {});

}  // namespace quadcut
