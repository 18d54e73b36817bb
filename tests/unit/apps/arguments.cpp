// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/arguments.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

using Words = std::vector<std::string>;

CommandForm sample_form() {
    CommandForm form;
    form.name = "paint";
    form.text = "Paints a wall.";
    form.operands = {"WALL", "COLOUR"};
    form.num_optional = 1;
    form.flags = {{"--output", "-o", "DIR", "where to"},
                  {"--layers", "", "N", "how many"},
                  {"--json", "", "", "machine readable"},
                  {"--set", "", "NAME=VALUE", "any option"}};
    form.settings = {"roller_width", "layers", "wall.paper"};
    form.planned_flags = {"--spray"};
    return form;
}

std::string error_of(const Words& words) {
    try {
        static_cast<void>(parse_arguments(sample_form(), words));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Arguments, FlagsAndOperandsInAnyOrder) {
    const Words words{"--json", "north", "--layers", "2", "red", "-o", "out"};
    const Arguments arguments = parse_arguments(sample_form(), words);
    EXPECT_EQ(arguments.operands, (Words{"north", "red"}));
    EXPECT_TRUE(arguments.has("--json"));
    EXPECT_EQ(arguments.value("--layers"), "2");
    EXPECT_EQ(arguments.value("--output"), "out");
    EXPECT_FALSE(arguments.has("--set"));
}

TEST(Arguments, ValueAfterEqualsSign) {
    const Words words{"north", "--layers=2", "--output=a=b"};
    const Arguments arguments = parse_arguments(sample_form(), words);
    EXPECT_EQ(arguments.value("--layers"), "2");
    EXPECT_EQ(arguments.value("--output"), "a=b");
}

TEST(Arguments, ValueMayBeANegativeNumber) {
    EXPECT_EQ(parse_arguments(sample_form(), Words{"n", "--layers", "-3"}).value("--layers"), "-3");
}

TEST(Arguments, DashIsAnOperandAndTwoDashesEndTheFlags) {
    EXPECT_EQ(parse_arguments(sample_form(), Words{"-", "--", "--json"}).operands,
              (Words{"-", "--json"}));
}

TEST(Arguments, HelpComesBeforeEverythingElse) {
    for (const char* word : {"--help", "-h"}) {
        EXPECT_TRUE(parse_arguments(sample_form(), Words{"--json", word}).has(kHelpFlag)) << word;
    }
}

TEST(Arguments, SetMayBeRepeatedOthersNot) {
    EXPECT_EQ(parse_arguments(sample_form(), Words{"n", "--set", "layers=1", "--set=wall.paper=2"})
                  .flags.size(),
              2U);
    EXPECT_EQ(error_of({"n", "--layers", "1", "--layers=2"}), "option --layers: given twice");
    EXPECT_EQ(error_of({"n", "-o", "a", "--output", "b"}), "option --output: given twice");
}

TEST(Arguments, RequiredFlagMustBeThere) {
    CommandForm form = sample_form();
    form.flags[0].is_required = true;
    EXPECT_NO_THROW(static_cast<void>(parse_arguments(form, Words{"n", "-o", "x"})));
    EXPECT_THROW(static_cast<void>(parse_arguments(form, Words{"n"})), InputError);
}

TEST(Arguments, Errors) {
    EXPECT_EQ(error_of({"n", "--bananas"}),
              "unknown option '--bananas'; 'quadcut paint --help' lists the options");
    EXPECT_EQ(error_of({"n", "--spray=1"}), "option --spray: not in this version of quadcut");
    EXPECT_EQ(error_of({"n", "--layers"}), "option --layers: expected N");
    EXPECT_EQ(error_of({"n", "--layers="}), "option --layers: expected N");
    EXPECT_EQ(error_of({"n", "--layers", "--json"}), "option --layers: expected N");
    EXPECT_EQ(error_of({"n", "--layers", "-o", "out"}), "option --layers: expected N");
    EXPECT_EQ(error_of({"n", "--json=1"}), "option --json: takes no value");
    EXPECT_EQ(error_of({}), "missing WALL; usage: quadcut paint WALL [COLOUR] [options]");
    EXPECT_EQ(error_of({"a", "b", "c", "-o", "d"}),
              "unexpected 'c'; usage: quadcut paint WALL [COLOUR] [options]");
}

struct Layers {
    double width_m = 0.1;
    std::size_t layers = 1;

    [[nodiscard]] std::vector<OptionField> fields() {
        return {{"roller_width", "m", 0.01, 1.0, "width of the roller", "", &width_m},
                {"layers", "", 1, 9, "how many", "", &layers}};
    }
};

TEST(SetFields, ByFlagAndBySet) {
    CommandForm form = sample_form();
    Layers values;
    form.flags.push_back(flag_of(values.fields(), "roller_width", "M"));
    const Words words{"n", "--roller-width", "0.5", "--set", "layers=4"};
    set_fields(parse_arguments(form, words), values.fields());
    EXPECT_EQ(values.width_m, 0.5);
    EXPECT_EQ(values.layers, 4U);
}

TEST(SetFields, TwiceOrWithoutValueIsAnError) {
    Layers values;
    const auto error = [&values](const Words& words) -> std::string {
        try {
            set_fields(parse_arguments(sample_form(), words), values.fields());
        } catch (const InputError& thrown) {
            return thrown.what();
        }
        return "no error";
    };
    EXPECT_EQ(error({"n", "--layers=2", "--set", "layers=3"}), "option layers: given twice");
    EXPECT_EQ(error({"n", "--set", "layers", "3"}),
              "option --set: 'layers': expected NAME=VALUE: did you mean '--set layers=3'?");
}

TEST(FlagOf, TextHasRangeUnitAndDefault) {
    Layers values;
    const Flag flag = flag_of(values.fields(), "roller_width", "M");
    EXPECT_EQ(flag.name, "--roller-width");
    EXPECT_EQ(flag.value, "M");
    EXPECT_EQ(flag.text, "width of the roller (0.01 to 1 m, default 0.1)");
}

}  // namespace
}  // namespace quadcut
