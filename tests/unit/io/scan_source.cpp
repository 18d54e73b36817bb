// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/scan_source.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/carmen.hpp"
#include "tests/unit/io/gzip.hpp"
#include "tests/unit/io/pipe.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::gzip;
using test::Pipe;
using test::ScratchFolder;

/// A FLASER of four beams, the longest of which has no return.
std::string flaser(double x, double time_s) {
    return "FLASER 4 1 2 3 81.9 " + std::to_string(x) + " 0 0 0 0 0 " + std::to_string(time_s) +
           " host 1\n";
}

/// A drive along x, a decimetre a scan; a scan has two lines.
std::string drive(std::size_t num_scans) {
    std::string log = "# a log\n";
    for (std::size_t i = 0; i < num_scans; ++i) {
        const auto number = static_cast<double>(i);
        log += flaser(0.1 * number, 100.0 + number) + "SYNC tag\n";
    }
    return log;
}

std::unique_ptr<ScanSource> open_log(const std::string& bytes,
                                     const ScanSourceOptions& options = {}) {
    return open_scan_source(Input({"", "x.log", "", bytes}), options);
}

std::vector<Scan> scans_of(ScanSource& source) {
    std::vector<Scan> scans;
    while (std::optional<Scan> scan = source.next()) scans.push_back(std::move(*scan));
    return scans;
}

void expect_same(const std::vector<Scan>& a, const std::vector<Scan>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].world_from_sensor, b[i].world_from_sensor);
        EXPECT_EQ(a[i].time_s, b[i].time_s);
        EXPECT_EQ(a[i].max_range_m, b[i].max_range_m);
        EXPECT_EQ(a[i].ranges_m, b[i].ranges_m);
    }
}

TEST(ScanSource, GivesTheScansOfALogOneByOne) {
    const auto source = open_log(drive(3));
    EXPECT_EQ(source->facts().name, "x.log");
    EXPECT_EQ(source->facts().num_scans, 3U);
    EXPECT_EQ(source->facts().content_hash, hash_bytes(drive(3)));
    EXPECT_TRUE(source->facts().warnings.empty());
    EXPECT_EQ(source->num_done(), 0U);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<Scan> scan = source->next();
        ASSERT_TRUE(scan.has_value());
        EXPECT_NEAR(scan->world_from_sensor.x, 0.1 * static_cast<double>(i), 1e-9);
        EXPECT_EQ(source->num_done(), i + 1);
        EXPECT_EQ(source->place(), "line " + std::to_string(2 * i + 2));
    }
    EXPECT_FALSE(source->next().has_value());
    EXPECT_EQ(source->num_done(), 3U);
}

/// What a laser gives for "no return" shows in all its scans; the first must know of the last.
TEST(ScanSource, GivesWhatReadingAllAtOnceGives) {
    const std::string log = drive(400);
    const LogFile whole = parse_carmen_log(log, "x.log");
    EXPECT_LT(whole.scans.front().max_range_m, kMaxUsableRange + 10.0);
    expect_same(scans_of(*open_log(log)), whole.scans);
    expect_same(scans_of(*open_log(gzip(log))), whole.scans);
    expect_same(scans_of(*open_log(log, {{}, 0.05, 2.5})),
                parse_carmen_log(log, "x.log", {2.5}).scans);
}

TEST(ScanSource, SkipsToAPosition) {
    const auto source = open_log(drive(10));
    skip_to(*source, 7);
    EXPECT_EQ(source->num_done(), 7U);
    EXPECT_NEAR(source->next()->world_from_sensor.x, 0.7, 1e-9);
    skip_to(*source, 100);
    EXPECT_EQ(source->num_done(), 10U);
}

/// Larger than what is kept of a pipe in memory, and than a piece.
TEST(ScanSource, BeginsAgainAsOftenAsOneLikes) {
    const auto source = open_log(drive(3));
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 1 + k; ++i) {
            EXPECT_NEAR(source->next().value().world_from_sensor.x, 0.1 * static_cast<double>(i),
                        1e-9);
        }
        EXPECT_EQ(source->num_done(), 1 + k);
        source->rewind();
        EXPECT_EQ(source->num_done(), 0U);
    }
}

TEST(ScanSource, ReadsFilesAndPipesAlike) {
    const ScratchFolder folder;
    const std::string log = drive(60'000);
    ASSERT_GT(log.size(), std::size_t{1} << 22U);
    const auto of_file = open_scan_source(Input(folder.write("a.log", log)), {});
    const Pipe pipe(folder, log);
    const auto of_pipe = open_scan_source(Input(pipe.path()), {});
    EXPECT_EQ(of_file->facts().content_hash, of_pipe->facts().content_hash);
    EXPECT_EQ(of_file->facts().scans_hash, of_pipe->facts().scans_hash);
    expect_same(scans_of(*of_file), scans_of(*of_pipe));
}

TEST(ScanSource, LeavesOutWhatIsTooFarAndSaysSoBeforeTheFirstScan) {
    const auto source = open_log(flaser(1e5, 0) + drive(5) + flaser(1e6, 900));
    EXPECT_EQ(source->facts().num_scans, 5U);
    ASSERT_EQ(source->facts().warnings.size(), 1U);
    const std::string& warning = source->facts().warnings[0];
    EXPECT_EQ(warning.find("x.log: line 1: the pose (100000, 0) is 100 km from "), 0U) << warning;
    EXPECT_NE(warning.find("; left out (2 of 7 scans)"), std::string::npos) << warning;
    const std::vector<Scan> scans = scans_of(*source);
    ASSERT_EQ(scans.size(), 5U);
    EXPECT_EQ(scans[0].world_from_sensor.x, 0.0);
}

TEST(ScanSource, GivesScansThePosesOfAFile) {
    const ScratchFolder folder;
    const auto poses = folder.write("p.tum", "101 5 6 0 0 0 0 1\n102 7 8 0 0 0 0 1\n");
    const auto source = open_log(drive(6), {poses, 0.05, {}});
    EXPECT_EQ(source->facts().num_scans, 2U);
    EXPECT_EQ(source->facts().warnings,
              std::vector<std::string>{poses.string() + ": no pose near 4 of the scans of x.log; "
                                                        "they are left out"});
    EXPECT_NE(source->facts().scans_hash, open_log(drive(6))->facts().scans_hash);
    EXPECT_EQ(source->facts().content_hash, open_log(drive(6))->facts().content_hash);
    EXPECT_EQ(source->next()->world_from_sensor, (Pose{5.0, 6.0, 0.0}));
    EXPECT_EQ(source->place(), "line 4");
    EXPECT_EQ(source->next()->world_from_sensor, (Pose{7.0, 8.0, 0.0}));
    EXPECT_FALSE(source->next().has_value());
    const auto late = folder.write("late.tum", "900 5 6 0 0 0 0 1\n901 5 6 0 0 0 0 1\n");
    EXPECT_EQ(error_of([&] {
                  open_log(drive(6), {late, 0.05, {}});
              }),
              late.string() +
                  ": no pose is near a scan in time: the poses are of 900 to 901 s, the scans of "
                  "100 to 105 s");
}

TEST(ScanSource, RefusesALogThatChangesWhileItIsFollowed) {
    const ScratchFolder folder;
    const auto path = folder.write("a.log", drive(10));
    const auto source = open_scan_source(Input(path), {});
    std::ofstream(path, std::ios::app) << flaser(9, 9);
    EXPECT_EQ(error_of([&] { scans_of(*source); }).find(path.string() + ": has changed"), 0U);
}

}  // namespace
}  // namespace quadcut::io
