// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <optional>

#include "io/map_yaml.hpp"
#include "io/pixel_states.hpp"

namespace quadcut::io {

// The histogram of a map's greys from what is occupied (0) to what is free (255): where `negate` is
// set, an image's greys are taken in reverse. Everything here is O(256).

/// What map_saver writes for unknown.
inline constexpr int kSaversUnknown = 205;

/// Greys first .. last; none when last < first.
struct GreyRange {
    int first = 0;
    int last = -1;
};

/// The share of each grey in the opaque pixels. @pre there are some.
class GreyShares {
public:
    GreyShares(const GreyTally& tally, bool negate);

    [[nodiscard]] double at(int grey) const { return shares_[static_cast<std::size_t>(grey)]; }
    /// Of the greys first .. last; 0 when there is none.
    [[nodiscard]] double of(int first, int last) const;
    /// Of all pixels but those of one grey. @pre there are others.
    [[nodiscard]] GreyShares without(int grey) const;

private:
    std::array<double, kWhite + 1> shares_{};
};

/// The greys that keys of mode trinary take for occupied and for free.
struct GreyBounds {
    int last_occupied = -1;
    int first_free = kWhite + 1;
};
[[nodiscard]] GreyBounds bounds_of(const MapKeys& keys);

/// The hump whose middle is within `reach` of `center`: a grey that stands far above those around
/// it, or neighbouring ones, as noise makes of one, that fall to a tenth within 20 greys.
[[nodiscard]] std::optional<GreyRange> find_hump(const GreyShares& shares, int center, int reach);

/// Whether at least half of the greys' pixels have one that stands far above those around it.
[[nodiscard]] bool is_mostly_even(const GreyShares& shares, const GreyRange& greys);

/// Walls are darker than `unknown`, floor is brighter. Without an unknown grey, `unknown` is empty
/// and lies where walls end (last) and floor begins (first).
struct GreyClasses {
    GreyRange unknown;
    /// Whether programs that write maps take it for unknown: about 205, or the middle.
    bool is_unknown_by_custom = false;
};
/// Nothing when there is only one class.
[[nodiscard]] std::optional<GreyClasses> find_grey_classes(const GreyShares& shares);

/// The one very frequent grey among the continuous greys of a floor, or 205 at an end of them: no
/// thresholds can tell it from them.
[[nodiscard]] std::optional<int> find_unknown_within_floor(const GreyShares& shares);

/// The first grey of the floor above an unknown one: after a sixth of the way to the floor's median
/// when that is mostly even, or of the widest gap below it, or the next grey when there is no gap.
[[nodiscard]] int border_above(const GreyShares& shares, int last_unknown);
/// The last grey of the walls, in the middle of such a gap.
[[nodiscard]] int border_below(const GreyShares& shares, int first_unknown);

}  // namespace quadcut::io
