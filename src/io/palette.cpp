// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <tuple>

namespace quadcut::io {
namespace {

/// Soft tints, chosen by hand in OKLCH (lightness 0.82 to 0.94, chroma 0.05 to 0.08): any two are
/// at least kClearDistance apart. Neighbours in the list are far apart in hue, so that rooms in
/// order get a lively sequence.
constexpr std::array<Rgb, 14> kTints = {{
    {0xAB, 0xD8, 0xF8},  // sky
    {0xFF, 0xD4, 0xB1},  // apricot
    {0xB2, 0xE8, 0xCF},  // mint
    {0xE3, 0xCC, 0xF9},  // lilac
    {0xF8, 0xEC, 0xB2},  // butter
    {0xFE, 0xC6, 0xC9},  // rose
    {0x97, 0xCF, 0xCE},  // teal
    {0xD4, 0xEC, 0xB8},  // pistachio
    {0xF2, 0xBB, 0xDA},  // orchid
    {0xE9, 0xCD, 0x96},  // ochre
    {0xB9, 0xC4, 0xF1},  // periwinkle
    {0xB5, 0xCF, 0xAF},  // sage
    {0xE8, 0xB7, 0xA1},  // clay
    {0xBA, 0xED, 0xF3},  // aqua
}};
/// Pale neutrals for corridors.
constexpr std::array<Rgb, 3> kNeutrals = {{
    {0xF5, 0xEE, 0xDE},  // ivory
    {0xDD, 0xE6, 0xEC},  // mist
    {0xE1, 0xD6, 0xCC},  // stone
}};
constexpr std::size_t kNumColors = kTints.size() + kNeutrals.size();

/// Colours farther apart than this are as good as any.
constexpr double kWellApart = 0.11;
/// What one more room in a colour costs, against distance.
constexpr double kCostOfUse = 0.004;

constexpr Rgb color_at(std::size_t i) {
    return i < kTints.size() ? kTints[i] : kNeutrals[i - kTints.size()];
}

struct Oklab {
    double lightness = 0.0;
    double a = 0.0;
    double b = 0.0;
};

double linear(std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Oklab to_oklab(Rgb color) {
    const double r = linear(color.red);
    const double g = linear(color.green);
    const double b = linear(color.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double distance(const Oklab& x, const Oklab& y) {
    return std::hypot(x.lightness - y.lightness, x.a - y.a, x.b - y.b);
}

std::array<Oklab, kNumColors> palette_looks() {
    std::array<Oklab, kNumColors> looks;
    for (std::size_t i = 0; i < kNumColors; ++i) looks[i] = to_oklab(color_at(i));
    return looks;
}

/// Greedy colouring: always the room with the most coloured neighbours next (Brelaz 1979).
class Coloring {
public:
    Coloring(std::span<const RoomKind> kinds, std::span<const RoomPair> pairs)
        : kinds_(kinds),
          pairs_(pairs),
          neighbours_(kinds.size()),
          num_colored_neighbours_(kinds.size(), 0),
          colors_(kinds.size()),
          looks_(kinds.size()) {
        for (const RoomPair& pair : pairs) {
            if (pair.a == 0 || pair.b > kinds.size() || pair.a >= pair.b) {
                throw std::logic_error("choose_room_colors: a pair names a room that is not there");
            }
            neighbours_[pair.a - 1U].push_back(pair.b - 1U);
            neighbours_[pair.b - 1U].push_back(pair.a - 1U);
        }
    }

    void keep(std::span<const std::optional<Rgb>> colors) {
        std::vector<std::vector<std::size_t>> touched_before(kinds_.size());
        for (const RoomPair& pair : pairs_) {
            if (pair.closeness == Closeness::across_wall) continue;
            touched_before[pair.b - 1U].push_back(pair.a - 1U);
        }
        for (std::size_t room = 0; room < colors.size(); ++room) {
            if (!colors[room]) continue;
            const Oklab look = to_oklab(*colors[room]);
            const auto& before = touched_before[room];
            const bool is_clear = std::all_of(before.begin(), before.end(), [&](std::size_t other) {
                return !looks_[other] || distance(*looks_[other], look) >= kClearDistance;
            });
            if (is_clear) paint(room, *colors[room], look);
        }
        for (std::size_t color = 0; color < kNumColors; ++color) {
            num_uses_[color] = static_cast<std::size_t>(
                std::count(colors_.begin(), colors_.end(), color_at(color)));
        }
    }

    std::vector<Rgb> run() {
        std::set<std::tuple<std::size_t, std::size_t, std::size_t>> open;
        // Sets sort ascending: "many" is counted down from the largest number there can be.
        const auto rank = [this](std::size_t room) {
            return std::tuple(kinds_.size() - num_colored_neighbours_[room],
                              kinds_.size() - neighbours_[room].size(), room);
        };
        for (std::size_t room = 0; room < kinds_.size(); ++room) {
            if (!looks_[room]) open.insert(rank(room));
        }
        while (!open.empty()) {
            const std::size_t room = std::get<2>(*open.begin());
            open.erase(open.begin());
            for (const std::size_t neighbour : neighbours_[room]) {
                if (!looks_[neighbour]) open.erase(rank(neighbour));
            }
            const std::size_t color = choose(room);
            paint(room, color_at(color), palette_[color]);
            ++num_uses_[color];
            for (const std::size_t neighbour : neighbours_[room]) {
                if (!looks_[neighbour]) open.insert(rank(neighbour));
            }
        }
        return colors_;
    }

private:
    void paint(std::size_t room, Rgb color, const Oklab& look) {
        colors_[room] = color;
        looks_[room] = look;
        for (const std::size_t neighbour : neighbours_[room]) ++num_colored_neighbours_[neighbour];
    }

    [[nodiscard]] double nearest_neighbour(std::size_t room, std::size_t color) const {
        double nearest = 1.0;
        for (const std::size_t neighbour : neighbours_[room]) {
            if (!looks_[neighbour]) continue;
            nearest = std::min(nearest, distance(palette_[color], *looks_[neighbour]));
        }
        return nearest;
    }

    [[nodiscard]] std::size_t choose(std::size_t room) const {
        const bool neutral = kinds_[room] == RoomKind::corridor;
        std::size_t best = 0;
        double best_worth = -1e9;
        for (std::size_t color = 0; color < kNumColors; ++color) {
            const double nearest = nearest_neighbour(room, color);
            double worth =
                std::min(nearest, kWellApart) - kCostOfUse * static_cast<double>(num_uses_[color]);
            // Being clear of the neighbours comes first, then the kind, then all else.
            if (nearest >= kClearDistance) worth += 2e6;
            if (neutral == (color >= kTints.size())) worth += 1e6;
            if (worth > best_worth) {
                best_worth = worth;
                best = color;
            }
        }
        return best;
    }

    std::span<const RoomKind> kinds_;
    std::span<const RoomPair> pairs_;
    std::vector<std::vector<std::size_t>> neighbours_;
    std::vector<std::size_t> num_colored_neighbours_;
    std::vector<Rgb> colors_;
    /// None yet: not coloured yet.
    std::vector<std::optional<Oklab>> looks_;
    std::array<std::size_t, kNumColors> num_uses_{};
    std::array<Oklab, kNumColors> palette_ = palette_looks();
};

}  // namespace

std::string to_hex(Rgb color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {color.red, color.green, color.blue}) {
        text += kDigits[channel >> 4U];
        text += kDigits[channel & 15U];
    }
    return text;
}

Rgb mixed(Rgb under, Rgb over, double share) {
    const auto channel = [share](std::uint8_t below, std::uint8_t above) {
        return static_cast<std::uint8_t>(std::lround(below + share * (above - below)));
    };
    return {channel(under.red, over.red), channel(under.green, over.green),
            channel(under.blue, over.blue)};
}

double perceived_distance(Rgb a, Rgb b) { return distance(to_oklab(a), to_oklab(b)); }

std::vector<Rgb> choose_room_colors(std::span<const RoomKind> kinds,
                                    std::span<const RoomPair> pairs,
                                    std::span<const std::optional<Rgb>> kept) {
    Coloring coloring(kinds, pairs);
    coloring.keep(kept);
    return coloring.run();
}

}  // namespace quadcut::io
