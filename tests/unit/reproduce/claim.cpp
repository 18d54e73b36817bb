// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/claim.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace quadcut::reproduce {
namespace {

Claim claim_of(const ByWorld& numbers, Bound bound) {
    return {"nodes", numbers, "%", bound, 25.0, "the paper's"};
}

TEST(Claim, ANumberKeepsItsLimitOrNot) {
    const auto is_held = [](double value, Bound bound) {
        return holds(claim_of({{"", value}}, bound));
    };
    EXPECT_TRUE(is_held(24.9, Bound::below));
    EXPECT_FALSE(is_held(25.0, Bound::below));
    EXPECT_TRUE(is_held(25.0, Bound::at_most));
    EXPECT_FALSE(is_held(25.1, Bound::at_most));
    EXPECT_TRUE(is_held(25.0, Bound::equal));
    EXPECT_FALSE(is_held(24.9, Bound::equal));
    EXPECT_TRUE(is_held(25.0, Bound::at_least));
    EXPECT_FALSE(is_held(24.9, Bound::at_least));
    EXPECT_TRUE(is_held(25.1, Bound::above));
    EXPECT_FALSE(is_held(25.0, Bound::above));
}

TEST(Claim, OneWorldThatDoesNotIsEnough) {
    EXPECT_TRUE(holds(claim_of({{"A", 1.0}, {"B", 2.0}}, Bound::below)));
    EXPECT_FALSE(holds(claim_of({{"A", 1.0}, {"B", 26.0}}, Bound::below)));
}

TEST(Claim, WhatWasNotMeasuredDoesNotHold) {
    EXPECT_FALSE(holds(claim_of({}, Bound::below)));
    EXPECT_FALSE(holds(claim_of({{"", std::nan("")}}, Bound::below)));
    EXPECT_FALSE(holds(claim_of({{"", HUGE_VAL}}, Bound::above)));
    EXPECT_EQ(measured_text(claim_of({}, Bound::below)), "not measured");
}

TEST(Claim, SaysWhatWasMeasuredAndTheLimit) {
    const Claim claim = claim_of({{"A", 1300.0}, {"B", 2.0}}, Bound::at_most);
    EXPECT_EQ(measured_text(claim), "1,300 % on A, 2 % on B");
    EXPECT_EQ(limit_text(claim), "at most 25 %");
    EXPECT_EQ(limit_text(claim_of({}, Bound::equal)), "25 %");
}

TEST(Claim, VerdictSaysHowManyClaimsHold) {
    const Claim good = claim_of({{"", 20.0}}, Bound::below);
    const Claim bad = claim_of({{"", 30.0}}, Bound::below);
    EXPECT_EQ(verdict({good}), "Agrees: nodes: 20 % (limit: below 25 %).");
    EXPECT_EQ(verdict({bad}), "Differs: nodes: 30 % (limit: below 25 %).");
    EXPECT_EQ(verdict({good, bad}),
              "Agrees in 1 of 2: nodes: 20 % (limit: below 25 %). "
              "Differs: nodes: 30 % (limit: below 25 %).");
    EXPECT_TRUE(agrees({good, good}));
    EXPECT_FALSE(agrees({good, bad}));
    EXPECT_EQ(count_held({good, bad, good}), 2U);
}

}  // namespace
}  // namespace quadcut::reproduce
