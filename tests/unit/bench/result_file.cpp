// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/result_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

std::string path_of(const std::string& name) { return testing::TempDir() + name; }

TEST(ResultFile, SaysWhereRowsComeFrom) {
    setenv("QUADCUT_BENCH_COMMIT", "abc1234", 1);
    setenv("QUADCUT_BENCH_COMMAND", "./run bench speed", 1);
    const std::string path = path_of("envelope.json");
    write_results(path, "speed", Json::array({{{"input", "lab"}, {"ms", 1.0 / 3.0}}}));
    const Json file = Json::parse(io::read_file(path));
    EXPECT_EQ(file["format_version"], 1);
    EXPECT_EQ(file["benchmark"], "speed");
    EXPECT_EQ(file["commit"], "abc1234");
    EXPECT_EQ(file["command"], "./run bench speed");
    EXPECT_EQ(file["date"].get<std::string>().size(), std::string("2026-01-02T03:04:05Z").size());
    EXPECT_GE(file["cores_of_others"], 0.0);
    EXPECT_GE(file["machine"]["cores"], 1);
    EXPECT_GT(file["machine"]["memory_gib"], 0.0);
    for (const char* key : {"cpu", "os", "compiler"}) {
        EXPECT_FALSE(file["machine"][key].get<std::string>().empty()) << key;
    }
    ASSERT_EQ(file["rows"].size(), 1U);
    EXPECT_EQ(file["rows"][0]["ms"], 0.333333);
    unsetenv("QUADCUT_BENCH_COMMIT");
    unsetenv("QUADCUT_BENCH_COMMAND");
}

TEST(ResultFile, NumbersHaveSixDigitsCountsAll) {
    Json row{{"count", 123456789}, {"deep", {{"small", 1.23456789e-12}, {"list", {2.0 / 3.0}}}}};
    result_file::round_numbers(row);
    EXPECT_EQ(row["count"], 123456789);
    EXPECT_EQ(row["deep"]["small"], 1.23457e-12);
    EXPECT_EQ(row["deep"]["list"][0], 0.666667);
}

TEST(ResultFile, NoRowsNoPath) {
    const std::string path = path_of("empty.json");
    write_results(path, "speed", Json::array());
    EXPECT_TRUE(Json::parse(io::read_file(path))["rows"].empty());
    write_results("", "speed", Json::array());
    EXPECT_THROW(write_results("/no such folder/a.json", "speed", Json::array()), InputError);
}

TEST(ResultFile, ValueOfAKey) {
    const std::string path = path_of("keys.txt");
    std::ofstream(path) << "other: 1\nmodel name\t:  A CPU \nPRETTY=\"An OS\"\nempty:\n";
    EXPECT_EQ(result_file::value_in(path.c_str(), "model name", ':'), "A CPU");
    EXPECT_EQ(result_file::value_in(path.c_str(), "PRETTY", '='), "An OS");
    EXPECT_EQ(result_file::value_in(path.c_str(), "empty", ':'), "");
    EXPECT_EQ(result_file::value_in(path.c_str(), "missing", ':'), "unknown");
}

}  // namespace
}  // namespace quadcut
