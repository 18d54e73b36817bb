// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/command_line.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(CommandLineText, WordsAsAShellTakesThem) {
    const std::vector<std::string> words{"segment", "it's my map.yaml", "", "-o", "/tmp/a_b-c=1"};
    EXPECT_EQ(command_line(words), R"(quadcut segment 'it'\''s my map.yaml' '' -o /tmp/a_b-c=1)");
}

}  // namespace
}  // namespace quadcut
