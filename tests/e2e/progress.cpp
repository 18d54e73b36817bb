// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"
#include "tests/e2e/terminal.hpp"

namespace quadcut::test {
namespace {

constexpr int kNumScans = 40;

/// A robot that stands in a niche for two seconds: as long as it is followed, whatever the machine.
std::string slow_log(const Folder& folder) {
    std::string log;
    for (int i = 0; i < kNumScans; ++i) {
        const std::string time = std::to_string(0.05 * i);
        log += "FLASER 5 2 2 2 2 2 0 0 0 0 0 0 " + time + " host " + time + "\n";
    }
    return folder.write("slow.log", log);
}

std::vector<std::string> follow(const Folder& folder) {
    return {"follow", slow_log(folder), "-o", folder / "out", "--speed", "1"};
}

bool has(const std::vector<std::string>& lines, const std::string& text) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
        return line.find(text) != std::string::npos;
    });
}

TEST(SlowProgress, FitsTheTerminalAndSaysHowLong) {
    const Folder folder;
    for (const int num_columns : {60, 80, 200}) {
        const Outcome outcome = run_in_terminal(follow(folder), {num_columns});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.out;
        const std::size_t first = outcome.out.find("follow  [");
        const std::size_t last = outcome.out.rfind("follow  [");
        ASSERT_NE(first, std::string::npos);
        // In place: nothing begins a line of the terminal between the first and the last.
        const std::string drawn = outcome.out.substr(first, last - first);
        EXPECT_EQ(drawn.find('\n'), std::string::npos);
        const std::vector<std::string> lines = drawn_lines(drawn);
        EXPECT_GT(lines.size(), 5U);
        EXPECT_LE(lines.size(), static_cast<std::size_t>(kNumScans));
        for (const std::string& line : lines) {
            EXPECT_LT(line.size(), static_cast<std::size_t>(num_columns)) << line;
        }
        EXPECT_TRUE(has(lines, " %")) << drawn;
        EXPECT_TRUE(has(lines, " s left")) << drawn;
        EXPECT_TRUE(has(lines, " scans/s")) << drawn;
        EXPECT_EQ(has(lines, "rooms"), num_columns > 60) << drawn;
    }
}

TEST(SlowProgress, AsksTheEnvironmentWhereTheTerminalDoesNotSay) {
    const Folder folder;
    const Outcome outcome = run_in_terminal(follow(folder), {0, "xterm", "70"});
    std::vector<std::string> lines = drawn_lines(outcome.out);
    std::erase_if(lines, [](const std::string& line) { return line.rfind("follow  [", 0) != 0; });
    ASSERT_FALSE(lines.empty()) << outcome.out;
    const auto widest = std::max_element(
        lines.begin(), lines.end(),
        [](const std::string& a, const std::string& b) { return a.size() < b.size(); });
    EXPECT_GT(widest->size(), 60U) << outcome.out;
    EXPECT_LT(widest->size(), 70U) << *widest;
}

TEST(Progress, AnInterruptEndsTheLine) {
    const Folder folder;
    const Outcome outcome = run_in_terminal(follow(folder), {80, "xterm", "80", "follow  ["});
    EXPECT_EQ(outcome.exit_code, 128 + 2);
    EXPECT_EQ(outcome.out.substr(outcome.out.size() - 2), "\r\n") << outcome.out;
    EXPECT_TRUE(files_below(folder / "out").empty());
}

TEST(SlowProgress, NothingIsDrawnWhereNothingCanBeRedrawn) {
    const Folder folder;
    const Outcome dumb = run_in_terminal(follow(folder), {80, "dumb"});
    EXPECT_EQ(dumb.exit_code, 0);
    EXPECT_EQ(dumb.out.find('['), std::string::npos) << dumb.out;
    EXPECT_EQ(run_quadcut(follow(folder)).err.find('\r'), std::string::npos);
}

}  // namespace
}  // namespace quadcut::test
