// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/pace.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

constexpr double kYearS = 365.25 * 86'400;

/// Plays stamps on a clock of the test's own, on which each scan takes `work_s`.
class Play {
public:
    explicit Play(double speed, double work_s = 0.0)
        : work_s_(work_s),
          pace_(speed, {[this] { return now_s_; },
                        [this](double time_s) { now_s_ = std::max(now_s_, time_s); }}) {}
    Play(const Play&) = delete;
    Play& operator=(const Play&) = delete;

    /// When each of them was due.
    std::vector<double> times_s(const std::vector<double>& stamps_s) {
        std::vector<double> times_s;
        for (const double stamp_s : stamps_s) {
            pace_.wait_for(stamp_s, [this] { return refine(); });
            times_s.push_back(now_s_);
            now_s_ += work_s_;
        }
        return times_s;
    }

    [[nodiscard]] std::string warning() const { return pace_.warning().value_or(""); }
    [[nodiscard]] int num_refined() const { return num_refined_; }

    /// Refinements that there are to be done, 0.1 s each.
    int num_to_refine = 0;

private:
    bool refine() {
        if (num_refined_ == num_to_refine) return false;
        ++num_refined_;
        now_s_ += 0.1;
        return true;
    }

    double now_s_ = 100.0;
    double work_s_;
    int num_refined_ = 0;
    Pace pace_;
};

using Times = std::vector<double>;

TEST(Pace, ScansAreDueWhenTheirStampsSay) {
    EXPECT_EQ(Play(1.0).times_s({7.0, 8.0, 8.5, 13.5}), (Times{100.0, 101.0, 101.5, 106.5}));
    EXPECT_EQ(Play(4.0).times_s({7.0, 9.0, 17.0}), (Times{100.0, 100.5, 102.5}));
    // What work delays is caught up with.
    EXPECT_EQ(Play(1.0, 3.0).times_s({0.0, 1.0, 9.0, 14.0}), (Times{100.0, 103.0, 109.0, 114.0}));
}

TEST(Pace, WithoutSpeedNothingIsWaitedFor) {
    Play play(0.0);
    EXPECT_EQ(play.times_s({7.0, 8.0, kYearS}), (Times{100.0, 100.0, 100.0}));
    EXPECT_EQ(play.warning(), "");
}

TEST(Pace, AHoleOfYearsTakesFiveSecondsAndIsTold) {
    Play play(2.0);
    EXPECT_EQ(play.times_s({0.0, 1.0, 3.0 * kYearS, 3.0 * kYearS + 1.0, 9.0 * kYearS}),
              (Times{100.0, 100.5, 105.5, 106.0, 111.0}));
    EXPECT_EQ(
        play.warning(),
        "the time stamps have 2 holes, the longest of 6 years: --speed went on after 5 s each "
        "time");
}

TEST(Pace, AWaitOfFiveSecondsIsNoHole) {
    Play play(2.0);
    EXPECT_EQ(play.times_s({0.0, 10.0}), (Times{100.0, 105.0}));
    EXPECT_EQ(play.warning(), "");
    EXPECT_EQ(play.times_s({130.0}), (Times{110.0}));
    EXPECT_EQ(
        play.warning(),
        "the time stamps have 1 hole, the longest of 2 minutes: --speed went on after 5 s each "
        "time");
}

TEST(Pace, StampsThatRunBackwardsAreNotWaitedFor) {
    EXPECT_EQ(Play(1.0).times_s({7.0, 8.0, 6.0, 9.0}), (Times{100.0, 101.0, 101.0, 102.0}));
    // Years back: what follows keeps its pace.
    EXPECT_EQ(Play(1.0).times_s({kYearS, 6.0, 9.0, 10.0}), (Times{100.0, 100.0, 103.0, 104.0}));
}

TEST(Pace, ScansWithoutAStampAreDueAtOnce) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(Play(1.0).times_s({none, 7.0, none, 9.0}), (Times{100.0, 100.0, 100.0, 102.0}));
}

TEST(Pace, RefinesMeanwhileAndIsInTime) {
    Play play(1.0);
    play.num_to_refine = 3;
    EXPECT_EQ(play.times_s({0.0, 1.0}), (Times{100.0, 101.0}));
    EXPECT_EQ(play.num_refined(), 3);
    play.num_to_refine = 1000;
    EXPECT_EQ(play.times_s({2.0}), (Times{102.0}));
    EXPECT_LT(play.num_refined(), 3 + 10);
}

}  // namespace
}  // namespace quadcut
