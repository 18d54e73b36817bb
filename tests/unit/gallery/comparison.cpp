// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/comparison.hpp"

#include <gtest/gtest.h>

namespace quadcut::gallery {
namespace {

/// Each character is 20 x 20 pixels of one region, numbered in order of the alphabet; '.' is none.
io::LabelImage drawn(const std::string& row) {
    constexpr std::size_t kSide = 20;
    std::vector<std::uint32_t> values;
    for (std::size_t y = 0; y < kSide; ++y) {
        for (const char mark : row) {
            values.insert(values.end(), kSide, mark == '.' ? 0U : static_cast<std::uint32_t>(mark));
        }
    }
    return io::number_regions(static_cast<std::int32_t>(row.size() * kSide), kSide, values);
}

TEST(GalleryComparison, OfThePerfectResultHasNoErrors) {
    const Comparison comparison = compare(drawn("aabb"), drawn("aabb"));
    EXPECT_EQ(comparison.found.size(), 2U);
    EXPECT_EQ(comparison.truth, (std::vector{Fate::found, Fate::found}));
    EXPECT_EQ(comparison.predicted, comparison.truth);
    EXPECT_EQ(error_text(comparison), "no errors");
}

TEST(GalleryComparison, ASmallRoomIsSwallowedByItsNeighbour) {
    const Comparison comparison = compare(drawn("aaaa"), drawn("aaab"));
    EXPECT_EQ(comparison.truth, (std::vector{Fate::found, Fate::swallowed}));
    EXPECT_EQ(comparison.predicted, (std::vector{Fate::found}));
    EXPECT_EQ(error_text(comparison), "true rooms: 1 merged");
}

TEST(GalleryComparison, ARoomCutIntoEqualPartsIsFoundInNone) {
    const Comparison comparison = compare(drawn("aabbcc"), drawn("aaaaaa"));
    EXPECT_EQ(comparison.truth, (std::vector{Fate::divided}));
    EXPECT_EQ(comparison.predicted, (std::vector(3, Fate::swallowed)));
    EXPECT_EQ(error_text(comparison), "true rooms: 1 split; result: 3 split");
}

TEST(GalleryComparison, WhatHasNoLabelOnTheOtherSideIsMissingOrFalse) {
    const Comparison comparison = compare(drawn("aa..cc"), drawn("aabb.."));
    EXPECT_EQ(comparison.truth, (std::vector{Fate::found, Fate::unseen}));
    EXPECT_EQ(comparison.predicted, (std::vector{Fate::found, Fate::unseen}));
    EXPECT_EQ(error_text(comparison), "true rooms: 1 missing; result: 1 false");
}

TEST(GalleryComparison, ARoomAcrossSeveralIsMerged) {
    const Comparison comparison = compare(drawn("aaaaaa"), drawn("aabbcc"));
    EXPECT_EQ(comparison.predicted, (std::vector{Fate::divided}));
    EXPECT_EQ(word_for_predicted(comparison.predicted[0]), "merged");
    EXPECT_EQ(comparison.truth, (std::vector(3, Fate::swallowed)));
}

}  // namespace
}  // namespace quadcut::gallery
