// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

// Under limits of bash's ulimit.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Not a test's failure: bash could not set the limit.
constexpr int kNoSuchLimit = 99;

/// Cuts the office into folder/NAME on eight threads under a limit.
Outcome cut_office_under(const Folder& folder, const std::string& name, const std::string& limit) {
    folder.write("office.pgm", office_pgm());
    const std::string map = folder.write("office.yaml", yaml_for("office.pgm"));
    const std::string script = limit + " || exit " + std::to_string(kNoSuchLimit) + "; exec \"$@\"";
    return run_process("/bin/bash", {"-c", script, "bash", QUADCUT_BINARY, "segment", map, "-o",
                                     folder / name, "--quiet", "--threads", "8"});
}

/// The files of a result; the report without what it took.
std::map<std::string, std::string> files_of(const Folder& folder, const std::string& name) {
    std::map<std::string, std::string> files = files_below(folder / name);
    auto report = nlohmann::ordered_json::parse(files.at("report.json"));
    report.erase("stages_ms");
    files["report.json"] = report.dump();
    return files;
}

void expect_fewer_under(const std::string& limit) {
    if (kIsSanitized) GTEST_SKIP() << "a sanitizer needs more than the limit leaves";
    const Folder folder;
    const Outcome free = cut_office_under(folder, "free", "true");
    ASSERT_EQ(free.exit_code, 0) << free.err;
    EXPECT_EQ(free.err, "");
    const Outcome limited = cut_office_under(folder, "limited", limit);
    if (limited.exit_code == kNoSuchLimit) GTEST_SKIP() << limited.err;
    ASSERT_EQ(limited.exit_code, 0) << limited.err;
    EXPECT_NE(limited.err.find("quadcut: warning: "), std::string::npos) << limited.err;
    EXPECT_NE(limited.err.find("could not be started"), std::string::npos) << limited.err;
    EXPECT_EQ(files_of(folder, "limited"), files_of(folder, "free"));
}

TEST(Limits, WithoutRoomForStacksOneDoesIt) {
    // 200 TB for a stack: more than there are addresses.
    expect_fewer_under("ulimit -s 200000000000");
}

TEST(Limits, AnAddressSpaceLeavesRoomForTheWork) { expect_fewer_under("ulimit -v 400000"); }

}  // namespace
}  // namespace quadcut::test
