// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/no_rooms.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "io/number_text.hpp"
#include "io/transparent_ground.hpp"

namespace quadcut::io {
namespace {

/// How many pixels have each state, not opaque ones with the unknown.
struct StateCounts {
    std::uint64_t num_free = 0;
    std::uint64_t num_occupied = 0;
    std::uint64_t num_unknown = 0;

    [[nodiscard]] std::uint64_t total() const { return num_free + num_occupied + num_unknown; }
};

StateCounts count_states(const GreyTally& tally, const MapKeys& keys) {
    StateCounts counts;
    counts.num_unknown = tally.num_not_opaque;
    for (std::size_t grey = 0; grey < tally.counts.size(); ++grey) {
        const CellState state = state_of_shade(static_cast<double>(grey) / kWhite, keys);
        std::uint64_t& count = state == CellState::free       ? counts.num_free
                               : state == CellState::occupied ? counts.num_occupied
                                                              : counts.num_unknown;
        count += tally.counts[grey];
    }
    return counts;
}

std::string percent(std::uint64_t count, const StateCounts& of) {
    const double share = 100.0 * static_cast<double>(count) / static_cast<double>(of.total());
    return rounded(share, share < 10.0 ? 1 : 0) + " %";
}

/// The grey nearest to free among the opaque pixels; -1 if there are none.
int freest_grey(const GreyTally& tally, const MapKeys& keys) {
    int freest = -1;
    for (int grey = 0; grey <= kWhite; ++grey) {
        if (tally.counts[static_cast<std::size_t>(grey)] == 0) continue;
        freest = grey;
        if (keys.negate) break;
    }
    return freest;
}

std::string why_nothing_is_free(const GreyTally& tally, const MapKeys& keys,
                                const StateCounts& counts) {
    const std::string nothing = "no pixel is free: ";
    if (tally.count() == 0) return nothing + "none is opaque";
    if (counts.num_unknown == 0) return nothing + "all are occupied";
    const int freest = freest_grey(tally, keys);
    std::string what =
        nothing + percent(counts.num_unknown, counts) + " are unknown, the others occupied";
    if (keys.mode == MapMode::raw || freest == 0) return what;
    const double occupancy = static_cast<double>(keys.negate ? freest : kWhite - freest) / kWhite;
    return what + "; the " + (keys.negate ? "darkest" : "brightest") + " grey is " +
           std::to_string(freest) + ", which --free-thresh " + rounded(occupancy + 0.001) +
           " would make free";
}

}  // namespace

std::string why_no_rooms(const GreyTally& tally, const MapKeys& keys) {
    constexpr std::uint64_t kMuchMore = 4;
    const StateCounts counts = count_states(tally, keys);
    if (counts.num_free == 0) return why_nothing_is_free(tally, keys, counts);
    MapKeys reversed = keys;
    reversed.negate = !keys.negate;
    const std::uint64_t num_ground =
        is_drawn_on_transparent(tally, reversed) ? tally.num_not_opaque : 0;
    const std::uint64_t num_free = count_states(tally, reversed).num_free + num_ground;
    // Walls that are read as floor are little; a map without any has not been exchanged.
    if (keys.mode == MapMode::raw || num_free < kMuchMore * counts.num_free) return "";
    return "only " + percent(counts.num_free, counts) +
           " of the pixels are free; if black and white are exchanged, " +
           (keys.negate ? "negate: 0 in the YAML" : "--negate") + " makes " +
           percent(num_free, counts) + " free";
}

}  // namespace quadcut::io
