// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/rooms/region_graph.hpp"

namespace quadcut::test {

/// What a RegionGraph of a floor without furniture takes beside its pieces: all is known, and no
/// wall's line goes on across it. The clearance must outlive it.
class PlainGround {
public:
    PlainGround(const Raster<float>& clearance_m, double resolution_m)
        : clearance_(clearance_m), resolution_m_(resolution_m), states_(clearance_m.box()) {
        for (std::size_t i = 0; i < states_.values.size(); ++i) {
            states_.values[i] =
                clearance_m.values[i] > 0.0F ? CellState::free : CellState::occupied;
        }
    }
    [[nodiscard]] Ground ground() const {
        return {clearance_, clearance_, states_, lines_, resolution_m_};
    }
    [[nodiscard]] NarrowingGauge gauge() const { return {clearance_, clearance_, resolution_m_}; }

private:
    const Raster<float>& clearance_;
    double resolution_m_;
    Raster<CellState> states_;
    WallLines lines_;
};

/// A border that looks the same whether furniture counts or not.
inline BorderMeasure plain_border(const Narrowing& narrowing) {
    BorderMeasure border;
    border.narrowing = narrowing;
    border.free_narrowing = narrowing;
    return border;
}

/// Of a room in which nothing stands.
inline RegionShape rectangle(double length_m, double width_m) {
    RegionShape shape;
    shape.area_m2 = length_m * width_m;
    shape.mean_clearance_m = 0.25 * width_m;
    shape.mean_free_clearance_m = shape.mean_clearance_m;
    shape.hull_m2 = shape.area_m2;
    shape.around_m = {length_m, width_m};
    return shape;
}

}  // namespace quadcut::test
