// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/grey_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

/// So many pixels of each grey in first .. last.
struct Greys {
    int first = 0;
    int last = 0;
    std::uint64_t count = 0;
};

GreyTally tally_of(const std::vector<Greys>& greys) {
    GreyTally tally;
    for (const Greys& some : greys) {
        for (int grey = some.first; grey <= some.last; ++grey) {
            tally.counts[static_cast<std::size_t>(grey)] += some.count;
        }
    }
    return tally;
}

GreyTally reversed(GreyTally tally) {
    std::reverse(tally.counts.begin(), tally.counts.end());
    return tally;
}

/// A grey with the noise of a normal distribution around it.
void add_noisy(GreyTally& tally, int grey, double sigma, double count) {
    for (int near = 0; near <= kWhite; ++near) {
        const double steps = (near - grey) / sigma;
        tally.counts[static_cast<std::size_t>(near)] += static_cast<std::uint64_t>(
            count * std::exp(-steps * steps / 2) / (sigma * std::sqrt(6.283)));
    }
}

MapKeys keys_of(double free_thresh, double occupied_thresh = 0.65, bool negate = false) {
    MapKeys keys;
    keys.free_thresh = free_thresh;
    keys.occupied_thresh = occupied_thresh;
    keys.negate = negate;
    return keys;
}

std::optional<GreyReading> find(const GreyTally& tally, const MapKeys& keys) {
    return find_grey_reading(tally, keys, NegateSource::file);
}

/// What greys are under the keys that the evidence leads to, ' ' unknown, '.' free, '#' occupied;
/// '=' in front when the evidence has nothing against the keys. It must be content with its own.
std::string read(const GreyTally& tally, const MapKeys& given, const std::vector<int>& greys) {
    const std::optional<GreyReading> found = find(tally, given);
    const MapKeys keys = found ? found->keys : given;
    if (found && !keys.unknown_grey) {
        EXPECT_FALSE(find(tally, keys)) << find(tally, keys)->reason;
    }
    std::string text = found ? "" : "=";
    for (const int grey : greys) {
        text += " .#"[static_cast<std::size_t>(
            state_of_shade(static_cast<double>(grey) / kWhite, keys))];
    }
    return text;
}

const GreyTally kSaved = tally_of({{0, 0, 50}, {205, 205, 700}, {254, 254, 250}});
/// As Cartographer's are: walls, the unknown grey, floor.
const GreyTally kContinuous = tally_of({{40, 115, 1}, {128, 128, 300}, {165, 235, 10}});

TEST(GreyEvidence, SaversGreysAreReadWhateverTheThresholds) {
    const std::vector<int> greys = {0, 205, 254};
    EXPECT_EQ(read(kSaved, keys_of(0.196), greys), "=# .");
    EXPECT_EQ(read(kSaved, keys_of(0.19), greys), "=# .");
    EXPECT_EQ(read(kSaved, keys_of(0.25), greys), "# .");
    EXPECT_EQ(read(kSaved, keys_of(0.6, 0.9), greys), "# .");
    EXPECT_EQ(read(kSaved, keys_of(0.0), greys), "# .");
    EXPECT_EQ(read(kSaved, keys_of(0.05, 0.1), greys), "# .");
    EXPECT_EQ(read(reversed(kSaved), keys_of(0.25, 0.65, true), {255, 50, 1}), "# .");
}

TEST(GreyEvidence, SaversGreysMayBeShiftedOrMissing) {
    const GreyTally shifted = tally_of({{1, 1, 50}, {206, 206, 700}, {253, 253, 250}});
    EXPECT_EQ(read(shifted, keys_of(0.196), {1, 206, 253}), "# .");
    const GreyTally no_walls = tally_of({{205, 205, 700}, {254, 254, 250}});
    EXPECT_EQ(read(no_walls, keys_of(0.25), {205, 254}), " .");
    const GreyTally no_floor = tally_of({{0, 0, 50}, {205, 205, 700}});
    EXPECT_EQ(read(no_floor, keys_of(0.25), {0, 205}), "# ");
    EXPECT_EQ(read(no_floor, keys_of(0.196), {0, 205}), "=# ");
    const GreyTally few = tally_of({{0, 0, 500}, {205, 205, 1}, {254, 254, 9000}});
    EXPECT_EQ(read(few, keys_of(0.25), {0, 205, 254}), "# .");
}

TEST(GreyEvidence, SaversGreysMayBeNoisy) {
    for (const double sigma : {1.0, 2.0, 4.0, 6.0, 8.0}) {
        GreyTally tally;
        add_noisy(tally, 4, sigma, 5e4);
        add_noisy(tally, 205, sigma, 7e5);
        add_noisy(tally, 254, sigma, 2.5e5);
        for (const double free_thresh : {0.196, 0.25}) {
            const std::vector<int> greys = {0, 200, 205, 208, 250, 255};
            const std::string states = read(tally, keys_of(free_thresh), greys);
            EXPECT_EQ(states, "#   ..") << sigma << " " << free_thresh;
        }
    }
}

TEST(GreyEvidence, BlackAndWhiteOfASaverMayBeExchanged) {
    EXPECT_EQ(read(reversed(kSaved), keys_of(0.196), {255, 50, 1}), "# .");
    EXPECT_EQ(read(reversed(kSaved), keys_of(0.25), {255, 50, 1}), "# .");
    EXPECT_EQ(read(kSaved, keys_of(0.196, 0.65, true), {0, 205, 254}), "# .");
    EXPECT_EQ(read(kSaved, keys_of(0.1, 0.9, true), {0, 205, 254}), "=. #");
    const GreyTally thick_walls = tally_of({{1, 1, 250}, {50, 50, 600}, {255, 255, 150}});
    EXPECT_EQ(read(thick_walls, keys_of(0.196), {255, 50, 1}), "# .");
    // Furniture of grey 50 and thick walls are no map in reverse.
    const GreyTally furnished = tally_of({{0, 0, 800}, {50, 50, 20}, {255, 255, 180}});
    EXPECT_EQ(read(furnished, keys_of(0.196), {0, 50, 255}), "=##.");
}

TEST(GreyEvidence, WhatPeopleSayOfBlackAndWhiteHolds) {
    const auto found = find_grey_reading(kSaved, keys_of(0.196, 0.65, true), NegateSource::person);
    EXPECT_TRUE(!found || found->keys.negate);
}

TEST(GreyEvidence, ContinuousGreysAreCutBetweenTheirHumps) {
    const std::vector<int> greys = {40, 115, 128, 165, 235};
    for (const double free_thresh : {0.0, 0.19, 0.196, 0.25}) {
        EXPECT_EQ(read(kContinuous, keys_of(free_thresh), greys), "## ..") << free_thresh;
    }
    EXPECT_EQ(read(kContinuous, keys_of(0.5, 0.5), greys), "## ..");
    EXPECT_EQ(read(reversed(kContinuous), keys_of(0.196, 0.65, true), {215, 140, 127, 90, 20}),
              "## ..");
    EXPECT_EQ(read(reversed(kContinuous), keys_of(0.196), {215, 140, 127, 90, 20}), "## ..");
    const GreyTally dark = tally_of({{20, 100, 1}, {127, 127, 300}, {150, 195, 10}});
    EXPECT_EQ(read(dark, keys_of(0.196), {20, 127, 150, 195}), "# ..");
    const GreyTally odd = tally_of({{20, 90, 1}, {150, 150, 300}, {180, 240, 10}});
    EXPECT_EQ(read(odd, keys_of(0.196), {20, 150, 180, 240}), "# ..");
}

TEST(GreyEvidence, TheUnknownMayLieAmongTheGreysOfTheFloor) {
    const GreyTally tally = tally_of({{40, 115, 1}, {205, 205, 900}, {165, 235, 10}});
    for (const double free_thresh : {0.196, 0.25, 0.4}) {
        EXPECT_EQ(read(tally, keys_of(free_thresh), {60, 165, 204, 205, 206, 235}), "#.. ..");
    }
    EXPECT_EQ(read(reversed(tally), keys_of(0.196, 0.65, true), {195, 90, 51, 50, 49}), "#.. .");
    EXPECT_EQ(read(reversed(tally), keys_of(0.196), {195, 90, 51, 50, 49}), "#.. .");
}

TEST(GreyEvidence, SaversUnknownMayBeBrighterThanAContinuousFloor) {
    const GreyTally tally = tally_of({{40, 80, 1}, {205, 205, 500}, {160, 203, 10}});
    EXPECT_EQ(read(tally, keys_of(0.196), {60, 160, 203, 205}), "#.. ");
    // Any other grey at the end is the surest floor.
    const GreyTally sure = tally_of({{40, 80, 1}, {230, 230, 200}, {160, 229, 10}});
    EXPECT_EQ(read(sure, keys_of(0.196), {60, 160, 229, 230}), "#...");
}

TEST(GreyEvidence, PaperThatWasScannedIsFloor) {
    GreyTally paper;
    add_noisy(paper, 60, 15.0, 5e4);
    add_noisy(paper, 205, 6.0, 9.5e5);
    EXPECT_EQ(read(paper, keys_of(0.196), {60, 195, 205, 215}), "#...");
}

TEST(GreyEvidence, CleanMapsAreLeftAlone) {
    // Plans, tinted ground, edges between floor and walls, furniture of a light grey.
    const std::vector<std::vector<Greys>> all = {
        {{0, 0, 30}, {255, 255, 970}},
        {{0, 0, 820}, {255, 255, 180}},
        {{0, 0, 30}, {128, 128, 600}, {255, 255, 370}},
        {{0, 177, 1}, {178, 178, 9000}, {255, 255, 15'000}},
        {{0, 170, 1}, {178, 178, 1700}, {211, 211, 170}, {208, 213, 5}, {255, 255, 7500}},
        {{0, 0, 50}, {180, 180, 2000}, {204, 204, 1800}, {205, 211, 30}, {255, 255, 5500}},
        {{0, 0, 30}, {1, 253, 1}, {254, 254, 9000}},
    };
    for (const std::vector<Greys>& greys : all) {
        for (const double free_thresh : {0.19, 0.196}) {
            const auto found = find(tally_of(greys), keys_of(free_thresh));
            EXPECT_FALSE(found) << found->reason;
        }
    }
    EXPECT_FALSE(find(GreyTally{}, keys_of(0.25)));
    for (int grey = 0; grey <= kWhite; ++grey) {
        (void)find(tally_of({{grey, grey, 1}}), keys_of(0.25));
    }
}

TEST(GreyEvidence, OtherModesHaveNoEvidence) {
    MapKeys keys = keys_of(0.25);
    keys.mode = MapMode::scale;
    EXPECT_FALSE(find(kSaved, keys));
    keys.mode = MapMode::raw;
    EXPECT_FALSE(find(kSaved, keys));
}

TEST(GreyEvidence, SaysWhyAndHow) {
    EXPECT_EQ(find(kSaved, keys_of(0.25))->reason,
              "grey 205 (70 %), which map_saver writes for unknown, would be free at free_thresh "
              "0.25; read with free_thresh 0.163");
    EXPECT_EQ(find(kContinuous, keys_of(0.0))->reason,
              "free_thresh 0.0 leaves nothing free; read with free_thresh 0.473, occupied_thresh "
              "0.524");
    EXPECT_EQ(find(reversed(kSaved), keys_of(0.196))->reason,
              "walls and floor have each other's greys; read with negate 1");
}

}  // namespace
}  // namespace quadcut::io
