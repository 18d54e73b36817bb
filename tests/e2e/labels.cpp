// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "tests/e2e/labels.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/image.hpp"
#include "tests/unit/io/image_file.hpp"

namespace quadcut::test {

Labels read_labels(const std::filesystem::path& path) {
    const io::Image image = io::read_image(path);
    Labels labels({0, 0}, image.header.width, image.header.height);
    const auto step = static_cast<std::size_t>(image.header.channels);
    for (std::int32_t y = 0; y < labels.height; ++y) {
        const auto row = image.row(labels.height - 1 - y);
        for (std::int32_t x = 0; x < labels.width; ++x) {
            labels.at({x, y}) = row[static_cast<std::size_t>(x) * step];
        }
    }
    return labels;
}

std::map<std::uint16_t, int> num_parts_by_label(const Labels& labels) {
    std::map<std::uint16_t, int> parts;
    Labels left = labels;
    std::vector<Cell> open;
    for (std::size_t i = 0; i < left.values.size(); ++i) {
        const std::uint16_t label = left.values[i];
        if (label == 0) continue;
        ++parts[label];
        open.push_back(left.cell(i));
        left.values[i] = 0;
        while (!open.empty()) {
            const Cell cell = open.back();
            open.pop_back();
            for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const Cell next{cell.x + dx, cell.y + dy};
                if (!left.contains(next) || left.at(next) != label) continue;
                left.at(next) = 0;
                open.push_back(next);
            }
        }
    }
    return parts;
}

}  // namespace quadcut::test
