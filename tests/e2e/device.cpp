// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// Cuts the office into folder/NAME by the preset `paper`, with variables of the environment.
Outcome cut_office(const Folder& folder, const std::string& name,
                   const std::vector<std::string>& more,
                   const std::vector<std::string>& environment = {}) {
    folder.write("office.pgm", office_pgm());
    const std::string map = folder.write("office.yaml", yaml_for("office.pgm"));
    // What PoCL and its compiler keep to the end is no leak of ours.
    const std::string not_ours =
        folder.write("suppressions", "leak:libpocl\nleak:libLLVM\nleak:libclang\n");
    std::vector<std::string> words{"POCL_CACHE_DIR=" QUADCUT_POCL_CACHE,
                                   "LSAN_OPTIONS=print_suppressions=0:suppressions=" + not_ours};
    words.insert(words.end(), environment.begin(), environment.end());
    words.insert(words.end(), {QUADCUT_BINARY, "segment", map, "-o", folder / name});
    words.insert(words.end(), more.begin(), more.end());
    return run_process("/usr/bin/env", words);
}

/// The files of a result; the report without what it took.
std::map<std::string, std::string> files_of(const Folder& folder, const std::string& name) {
    std::map<std::string, std::string> files = files_below(folder / name);
    auto report = nlohmann::ordered_json::parse(files.at("report.json"));
    report.erase("stages_ms");
    files["report.json"] = report.dump();
    return files;
}

void expect_same_as_on_the_cpu(const Folder& folder, const std::string& name) {
    const Outcome cpu = cut_office(folder, "cpu", {"--preset", "paper"});
    ASSERT_EQ(cpu.exit_code, 0) << cpu.err;
    EXPECT_EQ(cpu.err, "");
    EXPECT_EQ(files_of(folder, name), files_of(folder, "cpu"));
}

TEST(DeviceFlag, TheResultIsTheSameOnAnyDevice) {
    const Folder folder;
    for (const std::string device : {"cpu", "gpu", "auto"}) {
        const Outcome outcome =
            cut_office(folder, "out_" + device, {"--preset", "paper", "--device", device});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        expect_same_as_on_the_cpu(folder, "out_" + device);
    }
}

TEST(DeviceFlag, WithoutAPlatformTheCpuDoesItAndSaysSo) {
    const Folder folder;
    std::filesystem::create_directory(folder / "no_vendors");
    const Outcome outcome = cut_office(folder, "out", {"--preset", "paper", "--device", "gpu"},
                                       {"OCL_ICD_VENDORS=" + (folder / "no_vendors/")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: --device gpu: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("OpenCL"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("the CPU does the work"), std::string::npos) << outcome.err;
    expect_same_as_on_the_cpu(folder, "out");
}

TEST(DeviceFlag, WithoutSysTheCpuDoesItAndSaysSo) {
    // PoCL 3.1 aborts there.
    const std::string hide = "mount -t tmpfs none /sys";
    if (run_process("/usr/bin/unshare", {"-m", "/bin/sh", "-c", hide}).exit_code != 0) {
        GTEST_SKIP() << "nothing can be mounted here";
    }
    const Folder folder;
    const std::string script = hide + " && exec \"$@\"";
    const Outcome outcome = cut_office(folder, "out", {"--preset", "paper", "--device", "gpu"},
                                       {"unshare", "-m", "/bin/sh", "-c", script, "sh"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("the CPU does the work"), std::string::npos) << outcome.err;
    expect_same_as_on_the_cpu(folder, "out");
}

TEST(DeviceFlag, PlaysNoPartWhereNoGraphIsMade) {
    const Folder folder;
    const Outcome outcome = cut_office(folder, "out", {"--device", "gpu"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("--preset paper"), std::string::npos) << outcome.err;
}

TEST(DeviceFlag, AnotherWordIsRefused) {
    const Folder folder;
    const Outcome outcome = cut_office(folder, "out", {"--device", "tpu"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("cpu, gpu or auto"), std::string::npos) << outcome.err;
}

TEST(DeviceFlag, TheLibraryIsNotLoadedUnlessAskedFor) {
    // The loader says which libraries it opens.
    for (const std::string device : {"cpu", "auto"}) {
        const Folder folder;
        const Outcome outcome = cut_office(folder, "out", {"--preset", "paper", "--device", device},
                                           {"LD_DEBUG=files"});
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_NE(outcome.err.find("libc.so"), std::string::npos);
        EXPECT_EQ(outcome.err.find("libOpenCL"), std::string::npos);
    }
}

}  // namespace
}  // namespace quadcut::test
