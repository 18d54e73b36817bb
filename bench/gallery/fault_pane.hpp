// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "bench/gallery/faults.hpp"
#include "draw/canvas.hpp"
#include "draw/floor_plan.hpp"
#include "draw/typeface.hpp"

namespace quadcut::gallery {

/// A colour of the pane, and what it stands for.
struct FaultKey {
    io::Rgb ink;
    std::string text;
};

/// A map with what is wrong with its result: floor pale where it is right, borders that the result
/// has too many or too few in strong colours.
class FaultPane {
public:
    explicit FaultPane(const Exhibit& exhibit);

    /// `frame`, whose upper left corner is at `origin`: that of the pictures beside it.
    void draw(draw::Canvas& canvas, const Box& frame, const Point& origin, double pixels_per_cell,
              const draw::Typeface& typeface) const;
    /// The cells that it needs.
    [[nodiscard]] const Box& frame() const { return plan_.frame; }
    /// Of what there is, with the number and metres of the cuts.
    [[nodiscard]] std::vector<FaultKey> keys() const;
    /// "cuts too many: 4 (14 m), missed: 9 (19 m)"; empty where all are right.
    [[nodiscard]] std::string cuts_text() const;

private:
    [[nodiscard]] std::vector<FaultKey> cut_keys() const;

    Faults faults_;
    double resolution_m_;
    draw::FloorPlan plan_;
};

}  // namespace quadcut::gallery
