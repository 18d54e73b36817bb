// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/paper/options.hpp"
#include "quadcut/rooms/options.hpp"

namespace quadcut {

struct OptionField;

/// `rooms`: rooms as people see them. `paper`: the method as published.
enum class Preset : std::uint8_t { rooms, paper };

/// What becomes of rooms that the robot's way does not cross, when the way is known.
enum class Uncrossed : std::uint8_t {
    /// The preset `paper` drops them, `rooms` keeps them.
    by_preset,
    kept,
    /// They are no part of the map (the paper's Fig 12).
    dropped,
};

struct SegmentOptions {
    Preset preset = Preset::rooms;
    Uncrossed uncrossed = Uncrossed::by_preset;
    RoomsOptions rooms;
    PaperOptions paper;
    std::size_t seed = 1;
    /// Whether the result carries the hierarchy of granularities; preset `rooms`.
    bool with_hierarchy = false;
};

[[nodiscard]] bool drops_uncrossed(const SegmentOptions& options);

/// Adds the options of all stages, bound to the members of `options`, which must outlive the list.
void add_fields(SegmentOptions& options, std::vector<OptionField>& fields);

}  // namespace quadcut
