// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/grey_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/grey_classes.hpp"
#include "io/number_text.hpp"

namespace quadcut::io {
namespace {

/// A share of a class that may be read as something else: edges, noise.
constexpr double kEdges = 0.1;
/// Less than this of all pixels is no floor.
constexpr double kLeastFloor = 0.02;

/// So many times more floor than walls is no accident.
constexpr double kMuchMore = 3.0;

/// What is wrong with a reading.
struct Contradiction {
    bool unknown_is_free = false;
    bool unknown_is_occupied = false;
    bool nothing_is_free = false;
    bool floor_is_cut = false;

    [[nodiscard]] bool any() const {
        return unknown_is_free || unknown_is_occupied || nothing_is_free || floor_is_cut;
    }
    [[nodiscard]] bool of_floor() const { return nothing_is_free || floor_is_cut; }
};

Contradiction find_contradiction(const GreyShares& shares, const GreyClasses& classes,
                                 const GreyBounds& bounds) {
    const GreyRange& unknown = classes.unknown;
    const double allowed = kEdges * shares.of(unknown.first, unknown.last);
    Contradiction found;
    if (classes.is_unknown_by_custom) {
        const int first = std::max(unknown.first, bounds.first_free);
        const int last = std::min(unknown.last, bounds.last_occupied);
        found.unknown_is_free = shares.of(first, unknown.last) > allowed;
        found.unknown_is_occupied = shares.of(unknown.first, last) > allowed;
    }
    const double floor = shares.of(unknown.last + 1, kWhite);
    if (floor < kLeastFloor) return found;
    constexpr double kNothing = 0.01;
    const double unread = shares.of(unknown.last + 1, bounds.first_free - 1);
    found.nothing_is_free = unread > (1.0 - kNothing) * floor;
    found.floor_is_cut =
        unread > kEdges * floor && !is_mostly_even(shares, {unknown.last + 1, kWhite});
    return found;
}

/// The bounds with what is wrong mended, and all else as it was.
GreyBounds mended(const GreyShares& shares, const GreyClasses& classes, GreyBounds bounds,
                  const Contradiction& wrong) {
    const int first = classes.unknown.first;
    const int last = classes.unknown.last;
    if (wrong.unknown_is_free || wrong.of_floor()) {
        bounds.first_free = border_above(shares, last);
    }
    // Dark edges of clean floor say nothing of the walls.
    const bool walls_are_cut =
        wrong.floor_is_cut && !is_mostly_even(shares, {0, first - 1}) &&
        shares.of(bounds.last_occupied + 1, first - 1) > kEdges * shares.of(0, first - 1);
    if (wrong.unknown_is_occupied || walls_are_cut || bounds.last_occupied >= bounds.first_free) {
        bounds.last_occupied = std::min(border_below(shares, first), bounds.first_free - 1);
    }
    return bounds;
}

bool has_a_savers_greys_in_reverse(const GreyShares& shares, const GreyBounds& bounds) {
    constexpr int kReversedUnknown = kWhite - kSaversUnknown;
    constexpr double kLeastUnknown = 0.05;
    constexpr double kNearlyAll = 0.95;
    constexpr int kNoise = 12;
    const std::optional<GreyRange> unknown = find_hump(shares, kReversedUnknown, 2);
    if (!unknown || shares.of(unknown->first, unknown->last) < kLeastUnknown) return false;
    const double read_unknown = shares.of(std::max(unknown->first, bounds.last_occupied + 1),
                                          std::min(unknown->last, bounds.first_free - 1));
    const double floor = shares.of(0, kNoise);
    const double walls = shares.of(kWhite - kNoise, kWhite);
    // 1 is 254 in reverse; 0 may also be thick walls, and there is less white floor then.
    const double most_walls = shares.at(1) > shares.at(0) ? floor : floor / 2;
    const double all = floor + walls + shares.of(unknown->first, unknown->last);
    return read_unknown <= kEdges * shares.of(unknown->first, unknown->last) && all >= kNearlyAll &&
           walls > 0.0 && walls <= most_walls;
}

bool has_walls_for_floor(const GreyShares& shares, const GreyClasses& classes,
                         const Contradiction& wrong) {
    const GreyRange dark{0, classes.unknown.first - 1};
    return wrong.of_floor() && classes.is_unknown_by_custom && !is_mostly_even(shares, dark) &&
           shares.of(dark.first, dark.last) >
               kMuchMore * shares.of(classes.unknown.last + 1, kWhite);
}

std::string percent(double share) { return rounded(100.0 * share, share < 0.1 ? 1 : 0) + " %"; }

std::string grey_text(const GreyRange& greys) {
    return greys.first == greys.last
               ? "grey " + std::to_string(greys.first)
               : "greys " + std::to_string(greys.first) + " to " + std::to_string(greys.last);
}

std::string unknown_text(const GreyShares& shares, const GreyRange& unknown, bool negate) {
    const bool is_savers =
        unknown.first <= kSaversUnknown + 2 && unknown.last >= kSaversUnknown - 2;
    const GreyRange shown =
        negate ? GreyRange{kWhite - unknown.last, kWhite - unknown.first} : unknown;
    return grey_text(shown) + " (" + percent(shares.of(unknown.first, unknown.last)) + ")" +
           (is_savers && !negate ? ", which map_saver writes for unknown,"
                                 : ", between walls and floor,");
}

std::string reason_of(const GreyShares& shares, const GreyClasses& classes, const MapKeys& given,
                      const GreyBounds& bounds, const Contradiction& wrong) {
    if (wrong.of_floor()) {
        const double floor = shares.of(classes.unknown.last + 1, kWhite);
        const double unread = shares.of(classes.unknown.last + 1, bounds.first_free - 1);
        return "free_thresh " + exact(given.free_thresh) + " leaves " +
               (wrong.nothing_is_free ? "nothing free"
                                      : percent(unread / floor) + " of the floor's greys unknown");
    }
    return unknown_text(shares, classes.unknown, given.negate) + " would be " +
           (wrong.unknown_is_free ? "free at free_thresh " + exact(given.free_thresh)
                                  : "occupied at occupied_thresh " + exact(given.occupied_thresh));
}

std::string values_text(const MapKeys& keys, const MapKeys& given) {
    std::string text;
    if (keys.negate != given.negate) text = keys.negate ? "negate 1" : "negate 0";
    const auto add = [&](const char* name, double value, double before) {
        if (value != before) text += (text.empty() ? "" : ", ") + (name + exact(value));
    };
    add("free_thresh ", keys.free_thresh, given.free_thresh);
    add("occupied_thresh ", keys.occupied_thresh, given.occupied_thresh);
    return text;
}

/// A threshold half way between two neighbouring greys.
double threshold_between(int darker) {
    constexpr double kDigits = 1000.0;
    const double occupancy = 1.0 - (darker + 0.5) / kWhite;
    return std::clamp(std::round(occupancy * kDigits) / kDigits, 0.0, 1.0);
}

/// The thresholds, with black and white as they are given.
std::optional<GreyReading> find_thresholds(const GreyTally& tally, const MapKeys& given) {
    const GreyShares shares(tally, given.negate);
    const GreyBounds bounds = bounds_of(given);
    const std::optional<GreyClasses> classes = find_grey_classes(shares);
    if (!classes) return std::nullopt;
    const Contradiction wrong = find_contradiction(shares, *classes, bounds);
    if (!wrong.any()) return std::nullopt;
    const GreyBounds better = mended(shares, *classes, bounds, wrong);
    GreyReading reading{given, reason_of(shares, *classes, given, bounds, wrong)};
    if (better.first_free != bounds.first_free) {
        reading.keys.free_thresh = threshold_between(better.first_free - 1);
    }
    if (better.last_occupied != bounds.last_occupied) {
        reading.keys.occupied_thresh = threshold_between(better.last_occupied);
    }
    // Rounded, one may pass the other where no grey lies between them.
    reading.keys.free_thresh = std::min(reading.keys.free_thresh, reading.keys.occupied_thresh);
    return reading;
}

/// Thresholds and the unknown grey that lies between greys of the floor.
std::optional<GreyReading> find_unknown_grey(const GreyTally& tally, const MapKeys& given) {
    const GreyShares shares(tally, given.negate);
    const std::optional<int> unknown = find_unknown_within_floor(shares);
    if (!unknown) return std::nullopt;
    const GreyShares others = shares.without(*unknown);
    const std::optional<GreyClasses> classes = find_grey_classes(others);
    if (!classes) return std::nullopt;
    GreyReading reading{given, {}};
    reading.keys.unknown_grey = given.negate ? kWhite - *unknown : *unknown;
    reading.keys.free_thresh = threshold_between(border_above(others, classes->unknown.last) - 1);
    reading.keys.occupied_thresh = threshold_between(border_below(others, classes->unknown.first));
    reading.reason = "grey " + std::to_string(*reading.keys.unknown_grey) + " (" +
                     percent(shares.at(*unknown)) +
                     ") stands far above the greys of the floor around it and is unknown";
    return reading;
}

/// Walls are thin: there is less of them than of floor.
bool has_unknown_within_walls(const GreyShares& reversed) {
    const std::optional<int> unknown = find_unknown_within_floor(reversed);
    if (!unknown) return false;
    const GreyShares others = reversed.without(*unknown);
    const std::optional<GreyClasses> classes = find_grey_classes(others);
    return classes && others.of(classes->unknown.last + 1, kWhite) >
                          kMuchMore * others.of(0, classes->unknown.first - 1);
}

bool is_in_reverse(const GreyTally& tally, const MapKeys& given) {
    const GreyShares shares(tally, given.negate);
    const GreyBounds bounds = bounds_of(given);
    if (has_a_savers_greys_in_reverse(shares, bounds)) return true;
    if (has_unknown_within_walls(GreyShares(tally, !given.negate))) return true;
    const std::optional<GreyClasses> classes = find_grey_classes(shares);
    return classes &&
           has_walls_for_floor(shares, *classes, find_contradiction(shares, *classes, bounds));
}

}  // namespace

std::optional<GreyReading> find_grey_reading(const GreyTally& tally, const MapKeys& given,
                                             NegateSource source) {
    if (given.mode != MapMode::trinary || tally.count() == 0) return std::nullopt;
    MapKeys keys = given;
    std::string reason;
    if (source == NegateSource::file && is_in_reverse(tally, given)) {
        keys.negate = !keys.negate;
        reason = "walls and floor have each other's greys";
    }
    std::optional<GreyReading> found = find_unknown_grey(tally, keys);
    if (!found) found = find_thresholds(tally, keys);
    if (found) {
        keys = found->keys;
        reason += (reason.empty() ? "" : ", and ") + found->reason;
    }
    if (reason.empty()) return std::nullopt;
    return GreyReading{keys, reason + "; read with " + values_text(keys, given)};
}

}  // namespace quadcut::io
