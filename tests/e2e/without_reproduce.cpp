// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// Only of a build without the paper's experiments (-DQUADCUT_REPRODUCE=OFF).
#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

TEST(WithoutReproduce, SaysThatItWasLeftOut) {
    const Folder folder;
    const Outcome outcome = run_quadcut({"reproduce", "-o", folder / "paper", "--small"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("left out of this build"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("-DQUADCUT_REPRODUCE=ON"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace quadcut::test
