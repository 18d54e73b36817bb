// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apps/command.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// Runs a command line of a help in a folder.
Outcome run_line(const std::string& folder, const std::string& line) {
    constexpr std::string_view kProgram = "quadcut";
    EXPECT_EQ(line.rfind(kProgram, 0), 0U) << line;
    const std::string script =
        "cd '" + folder + "' && exec '" QUADCUT_BINARY "'" + line.substr(kProgram.size());
    return run_process("/bin/sh", {"-c", script});
}

TEST(SlowExamples, RunAsTheyAreInTheHelp) {
    const Folder all;
    ASSERT_EQ(run_line(all / "", "quadcut demo -o build/demo").exit_code, 0);
    for (const Command& command : commands()) {
        // No help needs what another says.
        const std::string folder = all / command.form.name;
        std::filesystem::create_directories(folder);
        std::filesystem::copy(all / "build", folder + "/build",
                              std::filesystem::copy_options::recursive);
        const std::string help = run_quadcut({command.form.name, "--help"}).out;
        for (const std::string& line : command.form.examples) {
            EXPECT_NE(help.find("\n  " + line + "\n"), std::string::npos) << help;
            const Outcome outcome = run_line(folder, line);
            EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
            EXPECT_EQ(outcome.err, "") << line;
        }
    }
}

}  // namespace
}  // namespace quadcut::test
