// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/option_text.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/options.hpp"

namespace quadcut::io {
namespace {

struct Sample {
    double width_m = 4.0;
    std::size_t count = 3;
    std::uint8_t kind = 0;

    [[nodiscard]] std::vector<OptionField> fields() {
        return {{"width", "m", 0.5, 10.0, "a width", "", &width_m},
                {"count", "", 1, 8, "a count", "", &count},
                {"kind", "", 0, 0, "a kind", "", Choice{&kind, {"round", "square"}}}};
    }
};

std::string error_of(Sample& sample, std::string_view name, std::string_view text) {
    try {
        set_option(sample.fields(), name, text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(OptionField, SetsNumbersCountsAndWords) {
    Sample sample;
    set_option(sample.fields(), "width", "2.5");
    set_option(sample.fields(), "count", "8");
    set_option(sample.fields(), "kind", "square");
    EXPECT_EQ(sample.width_m, 2.5);
    EXPECT_EQ(sample.count, 8U);
    EXPECT_EQ(sample.kind, 1U);
}

TEST(OptionField, TextReadsBack) {
    Sample sample;
    sample.width_m = 0.1 + 0.2 + 0.4;
    sample.count = 7;
    sample.kind = 1;
    Sample copy;
    for (const OptionField& field : sample.fields()) {
        set_option(copy.fields(), field.name, option_text(field));
    }
    EXPECT_EQ(copy.width_m, sample.width_m);
    EXPECT_EQ(copy.count, sample.count);
    EXPECT_EQ(copy.kind, sample.kind);
}

TEST(OptionField, RangesAreInclusive) {
    Sample sample;
    for (const char* text : {"0.5", "10"}) {
        EXPECT_EQ(error_of(sample, "width", text), "no error") << text;
    }
    for (const char* text : {"1", "8"}) {
        EXPECT_EQ(error_of(sample, "count", text), "no error") << text;
    }
}

TEST(OptionField, RejectedValueIsNamedWithWhatWasExpected) {
    Sample sample;
    for (const char* text : {"0.49", "10.01", "nan", "inf", "-inf", "", " 1", "1 ", "1m", "0x1"}) {
        const std::string error = error_of(sample, "width", text);
        EXPECT_NE(error.find("width"), std::string::npos) << text << ": " << error;
        EXPECT_NE(error.find("0.5 to 10 m"), std::string::npos) << text << ": " << error;
    }
    for (const char* text : {"0", "9", "-1", "2.0", "1e1", "", "99999999999999999999"}) {
        const std::string error = error_of(sample, "count", text);
        EXPECT_NE(error.find("whole number from 1 to 8"), std::string::npos)
            << text << ": " << error;
    }
    EXPECT_NE(error_of(sample, "kind", "oval").find("round or square"), std::string::npos);
}

TEST(OptionField, SaysWhatWasProbablyMeant) {
    Sample sample;
    EXPECT_EQ(error_of(sample, "kind", "sqare"),
              "option kind: 'sqare': expected round or square: did you mean 'square'?");
    EXPECT_EQ(error_of(sample, "kind", "oval"), "option kind: 'oval': expected round or square");
    const std::string number = "expected a number from 0.5 to 10 m";
    EXPECT_EQ(error_of(sample, "width", "1,5"),
              "option width: '1,5': " + number + ": did you mean '1.5'?");
    EXPECT_EQ(error_of(sample, "width", "2.5m"),
              "option width: '2.5m': " + number + ": did you mean '2.5'?");
    EXPECT_EQ(error_of(sample, "width", "150 cm"),
              "option width: '150 cm': " + number + ": did you mean '1.5'?");
    // What is not allowed, or has another unit, is not suggested.
    EXPECT_EQ(error_of(sample, "width", "15cm"), "option width: '15cm': " + number);
    EXPECT_EQ(error_of(sample, "width", "3ft"), "option width: '3ft': " + number);
}

TEST(OptionField, RejectedValueChangesNothing) {
    Sample sample;
    static_cast<void>(error_of(sample, "width", "11"));
    static_cast<void>(error_of(sample, "count", "9"));
    static_cast<void>(error_of(sample, "kind", "oval"));
    EXPECT_EQ(sample.width_m, Sample{}.width_m);
    EXPECT_EQ(sample.count, Sample{}.count);
    EXPECT_EQ(sample.kind, Sample{}.kind);
}

TEST(OptionField, UnknownNameNamesTheNearest) {
    Sample sample;
    EXPECT_NE(error_of(sample, "widht", "1").find("did you mean 'width'"), std::string::npos);
    const std::string far = error_of(sample, "xylophone", "1");
    EXPECT_NE(far.find("xylophone"), std::string::npos);
    EXPECT_EQ(far.find("did you mean"), std::string::npos);
}

TEST(OptionFields, DefaultsAreAllowedValues) {
    FollowOptions options;
    const std::vector<OptionField> fields = option_fields(options);
    for (const OptionField& field : fields) {
        EXPECT_NO_THROW(set_option(fields, field.name, option_text(field))) << field.name;
    }
}

TEST(OptionFields, NamesAreDifferentAndDocumented) {
    FollowOptions options;
    std::set<std::string_view> names;
    for (const OptionField& field : option_fields(options)) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
        EXPECT_FALSE(field.text.empty()) << field.name;
        if (!std::holds_alternative<Choice>(field.value)) {
            EXPECT_LT(field.low, field.high) << field.name;
        }
    }
}

TEST(OptionText, ACountMayHaveWordsForSomeOfItsValues) {
    std::size_t count = 0;
    const std::vector<OptionField> fields{
        {"parts", "", 1, 9, "how many", "", CountOrWord{&count, {{"none", 77}, {"auto", 0}}}}};
    EXPECT_EQ(option_text(fields[0]), "auto");
    set_option(fields, "parts", "5");
    EXPECT_EQ(count, 5U);
    EXPECT_EQ(option_text(fields[0]), "5");
    set_option(fields, "parts", "none");
    EXPECT_EQ(count, 77U);
    EXPECT_EQ(option_text(fields[0]), "none");
    for (const char* wrong : {"0", "10", "77", "-1", "nope", "", "3x"}) {
        EXPECT_THROW(set_option(fields, "parts", wrong), InputError) << wrong;
    }
    EXPECT_EQ(count, 77U);
}

TEST(OptionFields, AreBoundToTheirOptions) {
    FollowOptions follow;
    RunOptions run;
    const SegmentOptions& options = follow.segment;
    const std::vector<OptionField> fields = option_fields(follow, run);
    set_option(fields, "preset", "paper");
    set_option(fields, "submaps", "7");
    set_option(fields, "door_width", "1.25");
    set_option(fields, "granularity", "0.75");
    set_option(fields, "threads", "3");
    set_option(fields, "paper.laplacian", "area");
    set_option(fields, "scan.miss", "-3");
    set_option(fields, "follow.min_change", "0.5");
    EXPECT_EQ(options.preset, Preset::paper);
    EXPECT_EQ(options.paper.num_submaps, 7U);
    EXPECT_EQ(options.rooms.door_width_m, 1.25);
    EXPECT_EQ(options.rooms.granularity, 0.75);
    EXPECT_EQ(run.num_threads, 3U);
    EXPECT_EQ(options.paper.laplacian, LaplacianKind::area);
    EXPECT_EQ(follow.integrate.miss, -3);
    EXPECT_EQ(follow.min_change_m2, 0.5);
}

}  // namespace
}  // namespace quadcut::io
