// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Rows of a raster in a few parts for the threads; the parts do not depend on their number.
[[nodiscard]] inline std::size_t rows_per_part(std::size_t height) {
    constexpr std::size_t kMaxParts = 16;
    return std::max<std::size_t>(16, (height + kMaxParts - 1) / kMaxParts);
}

/// Cells beside each other that have one label: so many from column x of row y on.
struct LabelRun {
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t offset = 0;
    std::size_t num_cells = 0;
};

/// One tally for each label from 0 on, of all its cells: `add(tally, run)` for each run whose label
/// is not 0, and `merge(into, from)` for the tallies of parts of the raster, in their order.
/// O(cells).
template <typename Tally, typename Label, typename Add, typename Merge>
[[nodiscard]] std::vector<Tally> tally_by_label(const Raster<Label>& labels,
                                                const Executor& executor, const Add& add,
                                                const Merge& merge) {
    const auto width = static_cast<std::size_t>(labels.width);
    const auto height = static_cast<std::size_t>(labels.height);
    const std::size_t num_rows = rows_per_part(height);
    // Of the labels that a part has, in the order in which they come: of thousands it has few.
    struct Part {
        std::vector<std::size_t> labels;
        std::vector<Tally> tallies;
    };
    std::vector<Part> parts((height + num_rows - 1) / num_rows);
    parallel_for(executor, height, num_rows, [&](std::size_t first, std::size_t last) {
        Part part;
        // One more than the place; 0 = none yet.
        std::vector<std::uint32_t> place_of;
        for (std::size_t y = first; y < last; ++y) {
            const Label* const row = labels.values.data() + y * width;
            for (std::size_t x = 0; x < width;) {
                const std::size_t begin = x;
                const std::size_t label = row[x];
                while (++x < width && row[x] == label) {
                }
                if (label == 0) continue;
                if (label >= place_of.size()) place_of.resize(label + 1, 0);
                if (place_of[label] == 0) {
                    part.labels.push_back(label);
                    part.tallies.emplace_back();
                    place_of[label] = static_cast<std::uint32_t>(part.labels.size());
                }
                add(part.tallies[place_of[label] - 1],
                    LabelRun{begin, y, y * width + begin, x - begin});
            }
        }
        parts[first / num_rows] = std::move(part);
    });
    std::vector<Tally> all(1);
    for (Part& part : parts) {
        for (std::size_t i = 0; i < part.labels.size(); ++i) {
            if (part.labels[i] >= all.size()) all.resize(part.labels[i] + 1);
            merge(all[part.labels[i]], part.tallies[i]);
        }
    }
    return all;
}

/// The largest of some values, at least `least`.
[[nodiscard]] inline float largest(const float* values, std::size_t count, float least) {
    // Four at a time: each maximum waits for the one before.
    std::array<float, 4> most{least, least, least, least};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        for (std::size_t k = 0; k < 4; ++k) most[k] = std::max(most[k], values[i + k]);
    }
    for (; i < count; ++i) most[0] = std::max(most[0], values[i]);
    return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

/// Puts `now[label]` in place of each label. O(cells).
template <typename Label>
void renumber(Raster<Label>& labels, const std::vector<std::uint32_t>& now,
              const Executor& executor) {
    parallel_for(executor, labels.values.size(), std::size_t{1} << 16U,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i) {
                         labels.values[i] = static_cast<Label>(now[labels.values[i]]);
                     }
                 });
}

}  // namespace quadcut
