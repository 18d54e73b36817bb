// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/label_placement.hpp"
#include "draw/typeface.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::draw {

/// A room in which not even its number has space.
struct CrampedRoom {
    std::uint32_t room = 0;
    std::string number;
    /// A place in it, in cells.
    Point spot;
};

/// The page, pixels, and the size of the numbers on it.
struct CalloutPage {
    double width = 0.0;
    double height = 0.0;
    double text_size = 0.0;
};

/// The numbers of such rooms beside them, each with a line that leads there: as near as can be, on
/// other rooms only where there is no space elsewhere, and on no other text.
/// O(rooms + text on the page).
[[nodiscard]] std::vector<RoomLabel> place_callouts(const std::vector<CrampedRoom>& rooms,
                                                    const std::vector<RoomLabel>& labels,
                                                    const Raster<std::uint16_t>& ground,
                                                    const PageScale& scale, const CalloutPage& page,
                                                    const Typeface& typeface);

}  // namespace quadcut::draw
