// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

/// Cell corners as points of the map frame.
class MapFrame {
public:
    explicit MapFrame(const GridMap& map)
        : resolution_m_(map.resolution_m), map_from_image_(map.map_from_image) {}

    [[nodiscard]] Point corner(Cell cell) const {
        return transform(map_from_image_, {cell.x * resolution_m_, cell.y * resolution_m_});
    }
    /// The pose of the lower left corner of a cell: of an image whose first cell it is.
    [[nodiscard]] Pose pose_of(Cell cell) const {
        const Point point = corner(cell);
        return {point.x, point.y, map_from_image_.yaw_rad};
    }
    /// So many decimals that a metre's text is good to a tenth of a cell, and to a millimetre.
    [[nodiscard]] int decimals() const {
        constexpr int kMost = 9;
        const double tenth = resolution_m_ / 10.0;
        const int needed = static_cast<int>(std::ceil(-std::log10(tenth) - 1e-9));
        return std::clamp(needed, kMillimetreDecimals, kMost);
    }

private:
    double resolution_m_;
    Pose map_from_image_;
};

}  // namespace quadcut::io
