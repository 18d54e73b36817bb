// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/labels.hpp"

namespace quadcut {

Raster<std::uint32_t> as_raster(const io::LabelImage& image) {
    Raster<std::uint32_t> raster({0, 0}, image.width, image.height);
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const Cell cell = raster.cell(i);
        const auto row = static_cast<std::size_t>(image.height - 1 - cell.y);
        raster.values[i] = image.values[row * static_cast<std::size_t>(image.width) +
                                        static_cast<std::size_t>(cell.x)];
    }
    return raster;
}

}  // namespace quadcut
