// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "io/map_yaml.hpp"
#include "io/pixel_states.hpp"

namespace quadcut::io {

/// Other keys than those given, and why, as a sentence without its end.
struct GreyReading {
    MapKeys keys;
    std::string reason;
};

/// Who says what is black and what is white: a file may be wrong.
enum class NegateSource : std::uint8_t { file, person };

/// How an image of mode trinary is to be read when its greys contradict its keys; nothing when they
/// do not, or tell nothing. Under the keys returned, they do not contradict any more. Three classes
/// are looked for, from dark to bright: walls, one grey (or a narrow hump) for unknown, floor. Keys
/// contradict when
/// - the unknown grey comes out free or occupied: about 205 (savers), or 126 .. 129 between walls
///   and floor;
/// - nothing comes out free although there is something bright;
/// - one very frequent grey lies among the continuous greys of the floor (MapKeys::unknown_grey);
/// - a threshold cuts through floor of continuous greys. Floor that is mostly one grey is clean:
///   what else is bright is the edge of something, and stays as the keys have it.
/// Black and white are exchanged where the greys are those of a saver in reverse, or where, with
/// continuous greys around the unknown one, there would be three times more walls than floor.
[[nodiscard]] std::optional<GreyReading> find_grey_reading(const GreyTally& tally,
                                                           const MapKeys& given,
                                                           NegateSource source);

}  // namespace quadcut::io
