// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/command_help.hpp"

#include <string>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

CommandForm sample_form() {
    CommandForm form;
    form.name = "paint";
    form.text = "Paints a wall.";
    form.operands = {"WALL", "COLOUR"};
    form.num_optional = 1;
    form.flags = {{"--output", "-o", "DIR", "where to"}, {"--layers", "", "N", "how many"}};
    form.planned_flags = {"--spray"};
    return form;
}

TEST(UsageOf, RequiredFlagIsInIt) {
    CommandForm form = sample_form();
    EXPECT_EQ(usage_of(form), "quadcut paint WALL [COLOUR] [options]");
    form.flags[0].is_required = true;
    EXPECT_EQ(usage_of(form), "quadcut paint WALL [COLOUR] -o DIR [options]");
}

TEST(HelpOf, ListsWhatThereIsAndKeepsTheWidth) {
    CommandForm form = sample_form();
    form.flags.push_back({"--long", "", "X",
                          "many words and more words until the line has to be broken somewhere "
                          "between two of the words"});
    const std::string help = help_of(form);
    EXPECT_EQ(help.rfind("quadcut paint WALL [COLOUR] [options]\nPaints a wall.\n", 0), 0U);
    EXPECT_NE(help.find("  -o, --output DIR      where to\n"), std::string::npos) << help;
    EXPECT_EQ(help.find("--spray"), std::string::npos);
    EXPECT_EQ(help.find("Examples"), std::string::npos);
    std::size_t start = 0;
    while (start < help.size()) {
        const std::size_t end = help.find('\n', start);
        EXPECT_LE(end - start, 100U);
        start = end + 1;
    }
}

TEST(HelpOf, EndsWithTheExamples) {
    CommandForm form = sample_form();
    form.examples = {"quadcut paint north", "quadcut paint south red"};
    const std::string help = help_of(form);
    const std::string end = "build/demo):\n  quadcut paint north\n  quadcut paint south red\n";
    ASSERT_GT(help.size(), end.size());
    EXPECT_EQ(help.substr(help.size() - end.size()), end);
    EXPECT_NE(help.find("\n\nExamples ("), std::string::npos) << help;
}

}  // namespace
}  // namespace quadcut
