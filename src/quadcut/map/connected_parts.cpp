// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/connected_parts.hpp"

#include <numeric>
#include <utility>

namespace quadcut {

std::vector<std::size_t> ConnectedParts::num_cells() const {
    std::vector<std::size_t> result(count + std::size_t{1}, 0);
    for (const CellRun& run : runs) result[run.part] += run.end - run.begin;
    return result;
}

std::vector<std::vector<std::size_t>> ConnectedParts::cells_of(
    const std::vector<bool>& wanted) const {
    std::vector<std::vector<std::size_t>> result(count + std::size_t{1});
    for_each_run([&](const CellRun& run, std::size_t first) {
        if (!wanted[run.part]) return;
        std::vector<std::size_t>& cells = result[run.part];
        const std::size_t before = cells.size();
        cells.resize(before + run.end - run.begin);
        std::iota(cells.begin() + static_cast<std::ptrdiff_t>(before), cells.end(), first);
    });
    std::erase_if(result, [](const auto& cells) { return cells.empty(); });
    return result;
}

std::vector<bool> ConnectedParts::islands(double num_cells_of_large) const {
    std::vector<bool> result = on_edge();
    const std::vector<std::size_t> sizes = num_cells();
    for (std::uint32_t part = 0; part <= count; ++part) {
        result[part] =
            part != 0 && !result[part] && static_cast<double>(sizes[part]) < num_cells_of_large;
    }
    return result;
}

std::vector<bool> ConnectedParts::on_edge() const {
    std::vector<bool> result(count + std::size_t{1}, false);
    const std::size_t num_rows = row_begin.size() - 1;
    const auto length = static_cast<std::size_t>(width);
    for_each_run([&](const CellRun& run, std::size_t first) {
        const bool is_edge_row = first < length || first >= length * (num_rows - 1);
        if (is_edge_row || run.begin == 0 || run.end == length) result[run.part] = true;
    });
    return result;
}

std::uint32_t ConnectedParts::part_at(std::uint32_t column, std::size_t row) const {
    const auto end = runs.begin() + static_cast<std::ptrdiff_t>(row_begin[row + 1]);
    const auto found =
        std::upper_bound(runs.begin() + static_cast<std::ptrdiff_t>(row_begin[row]), end, column,
                         [](std::uint32_t x, const CellRun& run) { return x < run.end; });
    return found != end && found->begin <= column ? found->part : 0;
}

ConnectedParts join_runs(ConnectedParts keyed, Connectivity connectivity) {
    ConnectedParts parts = std::move(keyed);
    const std::uint32_t corner = connectivity == Connectivity::eight ? 1 : 0;
    LabelSets sets;
    // Of the runs of this row and of the one below.
    std::vector<std::uint32_t> keys;
    std::vector<std::uint32_t> keys_below;
    for (std::size_t y = 0; y + 1 < parts.row_begin.size(); ++y) {
        const std::size_t begin = parts.row_begin[y];
        const std::size_t begin_below = y > 0 ? parts.row_begin[y - 1] : begin;
        std::size_t below = begin_below;
        std::swap(keys, keys_below);
        keys.clear();
        for (std::size_t i = begin; i < parts.row_begin[y + 1]; ++i) {
            CellRun& run = parts.runs[i];
            const std::uint32_t key = std::exchange(run.part, 0);
            keys.push_back(key);
            while (below < begin && parts.runs[below].end + corner <= run.begin) ++below;
            // The last one that touches this run may touch the next one, too.
            for (std::size_t j = below; j < begin && parts.runs[j].begin < run.end + corner; ++j) {
                if (keys_below[j - begin_below] != key) continue;
                if (run.part == 0) {
                    run.part = parts.runs[j].part;
                } else {
                    sets.join(run.part, parts.runs[j].part);
                }
            }
            if (run.part == 0) run.part = sets.add();
        }
    }
    const std::vector<std::uint32_t> numbers = sets.take_numbers();
    parts.count = *std::max_element(numbers.begin(), numbers.end());
    for (CellRun& run : parts.runs) run.part = numbers[run.part];
    return parts;
}

ConnectedParts free_parts(const Raster<CellState>& states, const Executor& executor) {
    return connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free ? 1U : 0U; },
        Connectivity::four, executor);
}

}  // namespace quadcut
