// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/grey_classes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace quadcut::io {
namespace {

/// Beyond this share of its highest grey a hump ends.
constexpr double kFoot = 0.1;

/// How far customary greys are found off by programs that convert images.
constexpr int kShift = 2;

/// The mean share of the greys 2 .. 6 steps away.
double around(const GreyShares& shares, int grey) {
    constexpr int kNear = 2;
    constexpr int kFar = 6;
    double sum = 0.0;
    int count = 0;
    for (int other = std::max(grey - kFar, 0); other <= std::min(grey + kFar, kWhite); ++other) {
        if (std::abs(other - grey) < kNear) continue;
        sum += shares.at(other);
        ++count;
    }
    return sum / count;
}

bool stands_out(const GreyShares& shares, int grey) {
    constexpr double kFarAbove = 8.0;
    return shares.at(grey) > 0.0 && shares.at(grey) >= kFarAbove * around(shares, grey);
}

/// The mean over a grey and its neighbours two steps away on either side.
double smooth(const GreyShares& shares, int grey) {
    constexpr int kReach = 2;
    return shares.of(grey - kReach, grey + kReach) / (2 * kReach + 1);
}

template <typename Height>
int highest_near(int center, int reach, const Height& height) {
    int highest = center;
    for (int grey = center - reach; grey <= center + reach; ++grey) {
        if (height(grey) > height(highest)) highest = grey;
    }
    return highest;
}

/// The greys around `peak` that are at least kFoot of its height.
template <typename Height>
std::optional<GreyRange> hump_around(int peak, const Height& height) {
    constexpr int kMaxReach = 20;
    const double foot = kFoot * height(peak);
    GreyRange hump{peak, peak};
    while (hump.first > 0 && height(hump.first - 1) >= foot) --hump.first;
    while (hump.last < kWhite && height(hump.last + 1) >= foot) ++hump.last;
    if (peak - hump.first > kMaxReach || hump.last - peak > kMaxReach) return std::nullopt;
    return hump;
}

/// The grey at which the pixels of a range are halved; the first when there are none.
int median(const GreyShares& shares, const GreyRange& greys) {
    const double half = shares.of(greys.first, greys.last) / 2;
    double sum = 0.0;
    for (int grey = greys.first; grey <= greys.last; ++grey) {
        sum += shares.at(grey);
        if (sum >= half && sum > 0.0) return grey;
    }
    return greys.first;
}

/// The longest run of greys in a range with shares of at most `most`; may be empty.
GreyRange longest_gap(const GreyShares& shares, const GreyRange& greys, double most) {
    GreyRange longest{greys.first, greys.first - 1};
    int begin = greys.first;
    for (int grey = greys.first; grey <= greys.last; ++grey) {
        if (shares.at(grey) > most) {
            begin = grey + 1;
        } else if (grey - begin > longest.last - longest.first) {
            longest = {begin, grey};
        }
    }
    return longest;
}

/// The unknown grey by custom, when enough pixels have it.
std::optional<GreyRange> find_customary(const GreyShares& shares) {
    constexpr double kLeast = 0.01;
    constexpr double kLeastMiddle = 0.05;
    constexpr double kLeastWalls = 0.001;
    constexpr double kAll = 0.999;
    constexpr int kEnds = 12;
    std::optional<GreyRange> found = find_hump(shares, kSaversUnknown, kShift);
    double share = found ? shares.of(found->first, found->last) : 0.0;
    const double others = shares.of(0, kEnds) + shares.of(kWhite - kEnds, kWhite);
    if (share < kLeast && share + others < kAll) found = std::nullopt;
    // A broad one without anything brighter is paper that was scanned.
    constexpr int kNarrow = 3;
    const int width = found ? found->last - found->first : 0;
    if (width >= kNarrow && shares.of(found->last + width / 2, kWhite) < kLeast) {
        found = std::nullopt;
    }
    if (!found) share = 0.0;
    const std::optional<GreyRange> middle = find_hump(shares, kWhite / 2, kShift);
    if (middle && shares.of(middle->first, middle->last) >= std::max(kLeastMiddle, share) &&
        shares.of(0, middle->first - 1) >= kLeastWalls &&
        shares.of(middle->last + 1, kWhite) >= kLeast) {
        return middle;
    }
    return found;
}

/// The most frequent grey that has others on either side, walls and floor.
std::optional<GreyRange> find_most_frequent(const GreyShares& shares) {
    constexpr double kLeast = 0.05;
    constexpr double kLeastWalls = 0.001;
    constexpr double kLeastFloor = 0.02;
    constexpr int kEnds = 30;
    std::optional<GreyRange> found;
    double most = kLeast;
    for (int grey = kEnds; grey <= kWhite - kEnds; ++grey) {
        if (shares.at(grey) < most || !stands_out(shares, grey)) continue;
        if (shares.of(0, grey - 1) < kLeastWalls) continue;
        if (shares.of(grey + 1, kWhite) < kLeastFloor) break;
        most = shares.at(grey);
        found = GreyRange{grey, grey};
    }
    return found;
}

/// The grey from which two classes differ most: Otsu, "A threshold selection method from gray-level
/// histograms", 1979; of several as good, the middle.
std::optional<GreyRange> find_two_classes(const GreyShares& shares) {
    constexpr double kLeastWalls = 0.001;
    constexpr double kDarkestFloor = 140.0;
    double all = 0.0;
    for (int grey = 0; grey <= kWhite; ++grey) all += grey * shares.at(grey);
    double dark = 0.0;
    double dark_sum = 0.0;
    double best = 0.0;
    double floor_mean = 0.0;
    GreyRange at;
    for (int border = 1; border <= kWhite; ++border) {
        dark += shares.at(border - 1);
        dark_sum += (border - 1) * shares.at(border - 1);
        if (dark < kLeastWalls || dark >= 1.0) continue;
        const double step = (all - dark_sum) / (1.0 - dark) - dark_sum / dark;
        const double between = dark * (1.0 - dark) * step * step;
        if (between > best * (1.0 + 1e-9)) {
            best = between;
            floor_mean = (all - dark_sum) / (1.0 - dark);
            at.first = border;
        }
        if (between >= best * (1.0 - 1e-9)) at.last = border;
    }
    if (best == 0.0 || floor_mean < kDarkestFloor) return std::nullopt;
    const int middle = (at.first + at.last + 1) / 2;
    return GreyRange{middle, middle - 1};
}

}  // namespace

GreyShares::GreyShares(const GreyTally& tally, bool negate) {
    const auto total = static_cast<double>(tally.count());
    for (std::size_t grey = 0; grey < shares_.size(); ++grey) {
        const std::size_t from = negate ? kWhite - grey : grey;
        shares_[grey] = static_cast<double>(tally.counts[from]) / total;
    }
}

double GreyShares::of(int first, int last) const {
    double sum = 0.0;
    for (int grey = std::max(first, 0); grey <= std::min(last, kWhite); ++grey) sum += at(grey);
    return sum;
}

GreyShares GreyShares::without(int grey) const {
    GreyShares others = *this;
    const double all = 1.0 - at(grey);
    for (double& share : others.shares_) share /= all;
    others.shares_[static_cast<std::size_t>(grey)] = 0.0;
    return others;
}

GreyBounds bounds_of(const MapKeys& keys) {
    GreyBounds bounds;
    for (int grey = 0; grey <= kWhite; ++grey) {
        const double shade = static_cast<double>(keys.negate ? kWhite - grey : grey) / kWhite;
        const CellState state = state_of_shade(shade, keys);
        if (state == CellState::occupied) bounds.last_occupied = grey;
        if (state == CellState::free) bounds.first_free = std::min(bounds.first_free, grey);
    }
    return bounds;
}

std::optional<GreyRange> find_hump(const GreyShares& shares, int center, int reach) {
    const auto raw = [&](int grey) { return shares.at(grey); };
    const int single = highest_near(center, reach, raw);
    if (stands_out(shares, single)) return hump_around(single, raw);
    constexpr int kNoise = 3;
    const auto smoothed = [&](int grey) { return smooth(shares, grey); };
    const int top = highest_near(center, reach + kNoise, smoothed);
    if (!(smoothed(top) > 0.0)) return std::nullopt;
    const std::optional<GreyRange> hump = hump_around(top, smoothed);
    const bool is_there = hump && std::abs(hump->first + hump->last - 2 * center) <= 2 * reach + 1;
    return is_there ? hump : std::nullopt;
}

bool is_mostly_even(const GreyShares& shares, const GreyRange& greys) {
    constexpr double kLeast = 0.02;
    const double all = shares.of(greys.first, greys.last);
    double even = 0.0;
    for (int grey = greys.first; grey <= greys.last; ++grey) {
        if (shares.at(grey) >= kLeast * all && stands_out(shares, grey)) even += shares.at(grey);
    }
    return even >= all / 2;
}

std::optional<GreyClasses> find_grey_classes(const GreyShares& shares) {
    if (const auto customary = find_customary(shares)) return GreyClasses{*customary, true};
    if (const auto frequent = find_most_frequent(shares)) return GreyClasses{*frequent, false};
    if (const auto border = find_two_classes(shares)) return GreyClasses{*border, false};
    return std::nullopt;
}

std::optional<int> find_unknown_within_floor(const GreyShares& shares) {
    constexpr double kLeast = 0.05;
    constexpr double kLeastBeside = 0.01;
    constexpr int kBeside = 12;
    for (int grey = kBeside; grey <= kWhite - kBeside; ++grey) {
        if (shares.at(grey) < kLeast || !stands_out(shares, grey)) continue;
        const GreyShares others = shares.without(grey);
        const double below = others.of(grey - kBeside, grey - 1);
        const double above = others.of(grey + 1, grey + kBeside);
        // At an end of the floor's greys it may as well be the surest floor.
        const bool is_savers = std::abs(grey - kSaversUnknown) <= kShift;
        const double beside = is_savers ? std::max(below, above) : std::min(below, above);
        const std::optional<GreyRange> border = find_two_classes(others);
        if (beside >= kLeastBeside && border && grey >= border->first &&
            !is_mostly_even(others, {border->first, kWhite})) {
            return grey;
        }
    }
    return std::nullopt;
}

int border_above(const GreyShares& shares, int last_unknown) {
    const int first = last_unknown + 1;
    if (first > kWhite) return first;
    const GreyRange floor{first, kWhite};
    const double share = shares.of(first, kWhite);
    const int last = share > 0.0 ? median(shares, floor) - 1 : kWhite;
    const double most = kFoot * share / static_cast<double>(kWhite + 1 - first);
    // Whatever lies between two even greys is an edge.
    const GreyRange gap = is_mostly_even(shares, floor) ? GreyRange{first, last}
                                                        : longest_gap(shares, {first, last}, most);
    // Near to the unknown: greys in between are edges of the floor, and doors are narrow.
    constexpr int kPart = 6;
    return gap.last < gap.first ? first : gap.first + (gap.last + 1 - gap.first) / kPart;
}

int border_below(const GreyShares& shares, int first_unknown) {
    const int last = first_unknown - 1;
    if (last < 0) return last;
    const double share = shares.of(0, last);
    const int first = share > 0.0 ? median(shares, {0, last}) + 1 : 0;
    const double most = kFoot * share / static_cast<double>(last + 1);
    const GreyRange gap = longest_gap(shares, {first, last}, most);
    return gap.last < gap.first ? last : (gap.first + gap.last) / 2;
}

}  // namespace quadcut::io
