// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/components.hpp"

#include <algorithm>

namespace quadcut {
namespace {

// Free cells first_x .. end_x - 1 of one row.
struct Run {
    std::int32_t first_x = 0;
    std::int32_t end_x = 0;
    std::uint32_t parent = 0;  // of the union-find, an index in the list of runs
};

class RunSet {
public:
    // Appends the runs of a row and joins them with those of the row before.
    void add_row(const CellState* row, std::int32_t width) {
        const std::size_t previous_first = first_of_row_;
        const std::size_t previous_end = runs_.size();
        first_of_row_ = previous_end;
        std::size_t above = previous_first;
        for (std::int32_t x = 0; x < width; ++x) {
            if (row[x] != CellState::free) continue;
            const auto id = static_cast<std::uint32_t>(runs_.size());
            const std::int32_t first = x;
            while (x < width && row[x] == CellState::free) ++x;
            runs_.push_back({first, x, id});
            while (above < previous_end && runs_[above].end_x <= first) ++above;
            // The last run that touches this one may touch the next one, too.
            for (std::size_t i = above; i < previous_end && runs_[i].first_x < x; ++i) {
                join(static_cast<std::uint32_t>(i), id);
            }
        }
    }

    [[nodiscard]] std::uint32_t find_top(std::uint32_t run) {
        while (runs_[run].parent != run) {
            runs_[run].parent = runs_[runs_[run].parent].parent;
            run = runs_[run].parent;
        }
        return run;
    }

    [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }

private:
    // The earlier top stays, so that it is the component's first run.
    void join(std::uint32_t a, std::uint32_t b) {
        a = find_top(a);
        b = find_top(b);
        runs_[std::max(a, b)].parent = std::min(a, b);
    }

    std::vector<Run> runs_;
    std::size_t first_of_row_ = 0;
};

}  // namespace

FreeComponents find_free_components(const Raster<CellState>& states) {
    FreeComponents free{{states.origin, states.width, states.height}, {}};
    RunSet set;
    std::vector<std::size_t> first_of_row;
    for (std::int32_t y = 0; y < states.height; ++y) {
        first_of_row.push_back(set.runs().size());
        set.add_row(states.values.data() + std::ptrdiff_t{y} * states.width, states.width);
    }
    first_of_row.push_back(set.runs().size());

    std::vector<std::uint32_t> label(set.runs().size(), 0);
    for (std::int32_t y = 0; y < states.height; ++y) {
        const bool is_edge_row = y == 0 || y == states.height - 1;
        const auto row = free.labels.values.begin() + std::ptrdiff_t{y} * states.width;
        for (std::size_t i = first_of_row[static_cast<std::size_t>(y)];
             i < first_of_row[static_cast<std::size_t>(y) + 1]; ++i) {
            const std::uint32_t top = set.find_top(static_cast<std::uint32_t>(i));
            if (label[top] == 0) {
                free.components.emplace_back();
                label[top] = static_cast<std::uint32_t>(free.components.size());
            }
            const Run& run = set.runs()[i];
            std::fill(row + run.first_x, row + run.end_x, label[top]);
            FreeComponents::Component& component = free.components[label[top] - 1];
            const auto length = static_cast<std::size_t>(run.end_x - run.first_x);
            component.num_cells += length;
            const bool first = run.first_x == 0;
            const bool last = run.end_x == states.width && (states.width > 1 || !first);
            component.num_border_cells +=
                is_edge_row ? length : std::size_t{first} + std::size_t{last};
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
    bool is_all = true;
    for (std::size_t i = 0; i < free.components.size(); ++i) {
        if (2 * free.components[i].num_border_cells > border) {
            outside = i;
        } else if (free.components[i].num_cells >= min_cells) {
            is_all = false;
        }
    }
    return is_all ? std::nullopt : outside;
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
