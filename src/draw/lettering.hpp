// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "draw/floor_cells.hpp"
#include "draw/label_placement.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut::draw {

/// What is to be said in a room: its name and its area, or at least its number.
struct RoomWords {
    std::string name;
    std::string area;
    std::string number;
    /// In cells: a point well inside of the room, and the middle of its area.
    Point label_point;
    Point centroid;
};

/// The page, pixels: where cells lie on it, and what letters are scaled by.
struct LetteredPage {
    PageScale scale;
    double unit = 1.0;
    double width = 0.0;
    double height = 0.0;
};

/// The text of each room, words[i] that of the ground's value i + 1: the name in its middle, beside
/// the furniture where that does not make it much smaller; or where else in the room it is larger;
/// or the number, in it or with a line that leads there. O(cells).
[[nodiscard]] std::vector<RoomLabel> place_labels(const FloorCells& cells,
                                                  const std::vector<RoomWords>& words,
                                                  const LetteredPage& page,
                                                  const Executor& executor = {});

}  // namespace quadcut::draw
