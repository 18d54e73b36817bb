// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/score.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "quadcut/base/error.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::eval {
namespace {

/// Each character of the drawing is 20 x 20 pixels of one value; '.' is 0.
io::LabelImage drawn(const std::vector<std::string>& rows) {
    constexpr std::size_t kSide = 20;
    std::vector<std::uint32_t> values;
    for (const std::string& row : rows) {
        for (std::size_t copy = 0; copy < kSide; ++copy) {
            for (const char mark : row) {
                const std::uint32_t value = mark == '.' ? 0 : static_cast<std::uint32_t>(mark);
                values.insert(values.end(), kSide, value);
            }
        }
    }
    return io::number_regions(static_cast<std::int32_t>(rows.front().size() * kSide),
                              static_cast<std::int32_t>(rows.size() * kSide), values);
}

TEST(RoomScore, OfThePerfectResult) {
    const io::LabelImage image = drawn({"aab", "ccb"});
    const RoomScore score = score_rooms(image, image);
    EXPECT_EQ(score.pq, 1.0);
    EXPECT_EQ(score.f1_50, 1.0);
    EXPECT_EQ(score.f1_70, 1.0);
    EXPECT_EQ(score.miou, 1.0);
    EXPECT_EQ(score.precision, 1.0);
    EXPECT_EQ(score.recall, 1.0);
    EXPECT_EQ(score.mcc, 1.0);
    EXPECT_EQ(score.ari, 1.0);
    EXPECT_NEAR(score.vi_over, 0.0, 1e-12);
    EXPECT_NEAR(score.vi_under, 0.0, 1e-12);
    EXPECT_EQ(score.cover, 1.0);
    EXPECT_EQ(score.rooms, 3U);
    EXPECT_EQ(score.truth, 3U);
}

TEST(RoomScore, CountsARoomThatWasCutOnce) {
    // a is found whole; b is halved: the better half has IoU 1/2, which is not above 1/2.
    const RoomScore score = score_rooms(drawn({"aabc"}), drawn({"aabb"}));
    EXPECT_DOUBLE_EQ(score.pq, 1.0 / 2.5);
    EXPECT_DOUBLE_EQ(score.f1_50, 1.0 / 2.5);
    EXPECT_DOUBLE_EQ(score.miou, 1.5 / 2.0);
    EXPECT_DOUBLE_EQ(score.precision, 1.0);
    EXPECT_DOUBLE_EQ(score.recall, 0.75);
    EXPECT_NEAR(score.vi_over, 0.5, 1e-12);
    EXPECT_NEAR(score.vi_under, 0.0, 1e-12);
}

TEST(RoomScore, LeavesOutWhatOneSideDoesNotLabel) {
    const RoomScore score = score_rooms(drawn({"a.b"}), drawn({"aab"}));
    EXPECT_DOUBLE_EQ(score.pq, 1.0);
    EXPECT_DOUBLE_EQ(score.cover, 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(score.recall, 0.75);
}

TEST(RoomScore, CoverCountsFreePixelsOnly) {
    const io::LabelImage predicted = drawn({"a.b"});
    io::FreeMask mask{60, 20, std::vector<std::uint8_t>(1200, 1)};
    for (std::size_t i = 0; i < mask.is_free.size(); ++i) {
        const std::size_t x = i % 60;
        if (x >= 20 && x < 40) mask.is_free[i] = 0;
    }
    EXPECT_DOUBLE_EQ(score_rooms(predicted, drawn({"aab"}), mask).cover, 1.0);
    std::fill(mask.is_free.begin(), mask.is_free.end(), std::uint8_t{0});
    EXPECT_TRUE(std::isnan(score_rooms(predicted, drawn({"aab"}), mask).cover));
}

TEST(RoomScore, WithoutRoomsIsZero) {
    const RoomScore score = score_rooms(drawn({".."}), drawn({"ab"}));
    EXPECT_EQ(score.pq, 0.0);
    EXPECT_EQ(score.cover, 0.0);
    EXPECT_EQ(score.rooms, 0U);
    EXPECT_EQ(score.truth, 2U);
}

TEST(RoomScore, NamesBothSizesWhenTheyDiffer) {
    const std::string message = io::test::error_of([] {
        (void)score_rooms(drawn({"ab"}), drawn({"a", "b"}));
    });
    EXPECT_NE(message.find("40 x 20"), std::string::npos) << message;
    EXPECT_NE(message.find("20 x 40"), std::string::npos) << message;
    const std::string mask_message = io::test::error_of([] {
        (void)score_rooms(drawn({"ab"}), drawn({"ab"}), io::FreeMask{1, 1, {1}});
    });
    EXPECT_NE(mask_message.find("1 x 1"), std::string::npos) << mask_message;
}

TEST(WithoutVoid, DropsRegionsMostlyWhereTheTruthIsNothing) {
    // Wholly; half, which is not more than half; two parts of three.
    const io::LabelImage truth = drawn({"..pp..qrr"});
    const io::LabelImage predicted = drawn({"vvhhhmmma"});
    EXPECT_EQ(without_void(predicted, truth).values, drawn({"..hhhmmma"}).values);
    EXPECT_EQ(without_void(drawn({"vvvvhhmmm"}), truth).values, drawn({"vvvv..mmm"}).values);
    EXPECT_EQ(without_void(drawn({"vvv...aaa"}), truth).values, drawn({"......aaa"}).values);
}

TEST(WithoutVoid, LooksAtFreeCellsOnlyWhereItKnowsThem) {
    // Two of three are void, but of the free cells none or all.
    const io::LabelImage truth = drawn({"..pq"});
    const io::LabelImage predicted = drawn({"aaab"});
    io::FreeMask mask{80, 20, std::vector<std::uint8_t>(1600, 1)};
    EXPECT_EQ(without_void(predicted, truth, mask).num_regions, 1U);
    for (std::size_t i = 0; i < mask.is_free.size(); ++i) mask.is_free[i] = i % 80 < 40 ? 0 : 1;
    EXPECT_EQ(without_void(predicted, truth, mask).num_regions, 2U);
    std::fill(mask.is_free.begin(), mask.is_free.end(), std::uint8_t{0});
    EXPECT_EQ(without_void(predicted, truth, mask).num_regions, 2U) << "nothing says it is void";
}

TEST(WithoutVoid, NamesBothSizesWhenTheyDiffer) {
    const std::string message = io::test::error_of([] {
        (void)without_void(drawn({"ab"}), drawn({"ab"}), io::FreeMask{1, 1, {1}});
    });
    EXPECT_NE(message.find("1 x 1"), std::string::npos) << message;
}

TEST(RoomScore, AsJsonHasTheKeysInOrder) {
    RoomScore score;
    score.pq = 0.1;
    score.vi_over = 1e-9;
    score.rooms = 12;
    EXPECT_EQ(to_json(score),
              "{\n \"pq\": 0.1,\n \"f1_50\": 0.0,\n \"f1_70\": 0.0,\n \"miou\": 0.0,\n"
              " \"precision\": 0.0,\n \"recall\": 0.0,\n \"mcc\": 0.0,\n \"ari\": 0.0,\n"
              " \"vi_over\": 1e-09,\n \"vi_under\": 0.0,\n \"cover\": 0.0,\n \"rooms\": 12,\n"
              " \"truth\": 0\n}");
    score.miou = 1.0 / 3.0;
    EXPECT_EQ(nlohmann::json::parse(to_json(score))["miou"].get<double>(), 1.0 / 3.0);
}

TEST(RoomMatch, IsOneToOneAndTellsTheIou) {
    // The second true room is cut in two, of which one can match it.
    const io::LabelImage truth = drawn({"aabbb", "aabbb"});
    const io::LabelImage predicted = drawn({"xxyyz", "xxyyz"});
    const std::vector<RoomMatch> matches = match_rooms(predicted, truth);
    ASSERT_EQ(matches.size(), 2U);
    EXPECT_EQ(matches[0], (RoomMatch{1, 1, 1.0}));
    EXPECT_EQ(matches[1], (RoomMatch{2, 2, 2.0 / 3.0}));
    EXPECT_TRUE(match_rooms(drawn({"....."}), drawn({"aabbb"})).empty());
    EXPECT_THROW((void)match_rooms(predicted, drawn({"a"})), InputError);
}

}  // namespace
}  // namespace quadcut::eval
