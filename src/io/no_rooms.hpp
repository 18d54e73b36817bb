// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "io/map_yaml.hpp"
#include "io/pixel_states.hpp"

namespace quadcut::io {

/// Why a map may have no rooms, as far as its image tells: nothing in it is free, because all is
/// unknown or occupied, or the thresholds say so, or black and white are exchanged, which may also
/// be when little is free. One line without the file's name, with the flag of `segment` that would
/// help; empty when the image gives no reason. O(256).
[[nodiscard]] std::string why_no_rooms(const GreyTally& tally, const MapKeys& keys);

}  // namespace quadcut::io
