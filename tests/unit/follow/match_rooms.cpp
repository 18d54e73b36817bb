// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/match_rooms.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

TEST(MatchRooms, TheLargestPartStaysTheRoom) {
    const std::vector<double> earlier{10.0};
    const std::vector<double> now{3.0, 6.0};
    const Kinship kinship = match_rooms(earlier, now, {{0, 0, 3.0}, {0, 1, 6.0}});
    EXPECT_EQ(kinship.earlier[0].same, 1U);
    EXPECT_EQ(kinship.now[1].same, 0U);
    EXPECT_EQ(kinship.now[0].same, kNoKin);
    EXPECT_EQ(kinship.now[0].holder, 0U) << "split from it";
}

TEST(MatchRooms, ARoomThatIsSwallowedIsHeldByTheOther) {
    const Kinship kinship =
        match_rooms(std::vector{8.0, 2.0}, std::vector{10.0}, {{0, 0, 8.0}, {1, 0, 2.0}});
    EXPECT_EQ(kinship.earlier[0].same, 0U);
    EXPECT_EQ(kinship.earlier[1].same, kNoKin);
    EXPECT_EQ(kinship.earlier[1].holder, 0U) << "merged into it";
}

TEST(MatchRooms, LessThanHalfOfBothIsAnother) {
    const Kinship kinship = match_rooms(std::vector{10.0}, std::vector{10.0}, {{0, 0, 4.9}});
    EXPECT_EQ(kinship.earlier[0].same, kNoKin);
    EXPECT_EQ(kinship.earlier[0].holder, kNoKin);
    EXPECT_EQ(kinship.now[0].holder, kNoKin);
}

TEST(MatchRooms, OfEqualPairsTheFirstInTheListIsTheSame) {
    const std::vector<double> two{4.0, 4.0};
    EXPECT_EQ(match_rooms(two, std::vector{8.0}, {{1, 0, 4.0}, {0, 0, 4.0}}).now[0].same, 1U);
    EXPECT_EQ(match_rooms(two, std::vector{8.0}, {{0, 0, 4.0}, {1, 0, 4.0}}).now[0].same, 0U);
}

TEST(MatchRooms, NoTwoShareMoreThanWithTheirPartners) {
    Random random(11);
    for (int round = 0; round < 50; ++round) {
        std::vector<double> earlier(6, 0.0);
        std::vector<double> now(6, 0.0);
        std::vector<Meeting> meetings;
        for (std::size_t e = 0; e < earlier.size(); ++e) {
            for (std::size_t n = 0; n < now.size(); ++n) {
                if (random.below(2) == 0) continue;
                const double shared = random.uniform(0.0, 20.0);
                meetings.push_back({e, n, shared});
                earlier[e] += shared;
                now[n] += shared;
            }
        }
        const Kinship kinship = match_rooms(earlier, now, meetings);
        const auto shared_by_same = [&](std::size_t e, std::size_t n) {
            for (const Meeting& meeting : meetings) {
                if (meeting.earlier == e && meeting.now == n) return meeting.shared;
            }
            return 0.0;
        };
        for (const Meeting& meeting : meetings) {
            if (2.0 * meeting.shared < std::min(earlier[meeting.earlier], now[meeting.now]))
                continue;
            const std::size_t is = kinship.earlier[meeting.earlier].same;
            const std::size_t was = kinship.now[meeting.now].same;
            const double with_is = is == kNoKin ? 0.0 : shared_by_same(meeting.earlier, is);
            const double with_was = was == kNoKin ? 0.0 : shared_by_same(was, meeting.now);
            EXPECT_GE(std::max(with_is, with_was), meeting.shared);
            if (is != kNoKin) {
                EXPECT_EQ(kinship.now[is].same, meeting.earlier);
            }
        }
    }
}

}  // namespace
}  // namespace quadcut
