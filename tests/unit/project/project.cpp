// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::store {
namespace {

using io::test::error_of;
using io::test::ScratchFolder;
using test::scans_in;
using test::small_building;
using testing::HasSubstr;

LogPosition some_log() {
    LogPosition position;
    position.log = "robot.log";
    position.log_hash = 0xfedcba9876543210U;
    return position;
}

std::filesystem::path project_of_two_rooms(const ScratchFolder& folder) {
    const auto path = folder.path() / "p.quadcut";
    Project project = Project::create(path, {}, some_log());
    Follower follower = project.follower();
    follower.update_cells(test::hall_with_wall());
    project.save(follower, some_log());
    return path;
}

TEST(Project, AFollowerGoesOnFromWhatWasSaved) {
    const ScratchFolder folder;
    const std::vector<Scan> scans = scans_in(small_building(3));
    const auto path = folder.path() / "p.quadcut";
    Follower whole;
    std::size_t at = 0;
    {
        Project project = Project::create(path, {}, some_log());
        Follower follower = project.follower();
        LogPosition position = some_log();
        for (; at < scans.size() / 2; ++at) {
            whole.add_scan(scans[at]);
            project.add(follower.add_scan(scans[at]), "line\n");
            if (at % 50 != 0) continue;
            position.num_done = at + 1;
            project.save(follower, position);
        }
        position.num_done = at;
        project.save(follower, position);
        // What comes after the last save is lost.
        follower.add_scan(scans[at]);
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"p.quadcut"});
    const Project project(path, Access::read);
    EXPECT_EQ(project.integrity(), "ok");
    EXPECT_EQ(project.position().num_done, at);
    EXPECT_EQ(project.position().log_hash, some_log().log_hash);
    EXPECT_EQ(project.update_lines().size(), 5 * at);
    Follower follower = project.follower();
    for (; at < scans.size(); ++at) {
        const FollowUpdate a = whole.add_scan(scans[at]);
        const FollowUpdate b = follower.add_scan(scans[at]);
        ASSERT_EQ(a.nodes_touched, b.nodes_touched) << at;
        ASSERT_EQ(a.ps, b.ps) << at;
        ASSERT_EQ(a.graph_nodes, b.graph_nodes) << at;
        ASSERT_EQ(a.events.size(), b.events.size()) << at;
    }
    whole.finish();
    follower.finish();
    EXPECT_EQ(whole.rooms().labels.values, follower.rooms().labels.values);
    EXPECT_EQ(whole.rooms().next_id, follower.rooms().next_id);
}

TEST(Project, EditsAreRowsThatStay) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    {
        Project project = Project::create(path, {}, some_log());
        Follower follower = project.follower();
        follower.update_cells(test::bare_hall());
        const RoomId hall = follower.room_at({9.0, 3.0});
        project.add({"rename", hall, {}, "Hall", {}}, follower.edit(test::rename(hall, "Hall")));
        const Edited split = follower.edit(test::split({4.0, 1.0}, {4.0, 5.0}));
        project.add({"split", hall, split.inverse.other, "", follower.state().split_lines.back()}, split);
        project.save(follower, some_log());
    }
    const Project project(path, Access::read);
    ASSERT_EQ(project.edits().size(), 2U);
    EXPECT_EQ(project.edits()[0].name, "Hall");
    EXPECT_EQ(project.edits()[1].kind, "split");
    Follower follower = project.follower();
    follower.update_cells(Raster<CellState>({150, 60}, 12, 12, CellState::occupied));
    EXPECT_EQ(follower.num_rooms(), 2U) << "the line is still a cut";
    EXPECT_EQ(follower.state().rooms.at(1).name, "Hall");
}

TEST(Project, WhatIsNoProjectIsRefused) {
    const ScratchFolder folder;
    const auto open = [&](const std::filesystem::path& path) {
        return error_of([&] { Project(path, Access::write); });
    };
    EXPECT_THAT(open(folder.path() / "none"), HasSubstr("none: there is no such project file"));
    EXPECT_THAT(open(folder.path()), HasSubstr("is a folder: expected a project file"));
    EXPECT_THAT(open(folder.write("empty", "")), HasSubstr("empty: is no project file"));
    EXPECT_THAT(open(folder.write("text", std::string(5000, 'x'))),
                HasSubstr("text: is no project file"));
    Database other = Database::in_memory(folder.path() / "other");
    other.run("CREATE TABLE t(x)");
    folder.write("other", other.file_bytes());
    EXPECT_THAT(open(folder.path() / "other"), HasSubstr("other: is no project file"));
    const auto path = folder.path() / "p.quadcut";
    static_cast<void>(Project::create(path, {}, some_log()));
    EXPECT_EQ(open(path), "no error");
    Database(path, Access::write).run("CREATE TABLE extra(x)");
    EXPECT_THAT(open(path), HasSubstr("its tables are not"));
    Database(path, Access::write).run("DROP TABLE extra; PRAGMA user_version=3");
    EXPECT_THAT(open(path), HasSubstr("format version 3: expected 1 to 2; a newer quadcut"));
}

TEST(Project, RowsThatCannotBeAreRefused) {
    const ScratchFolder folder;
    const auto path = project_of_two_rooms(folder);
    const std::string good = io::read_file(path);
    for (const std::string sql : {"UPDATE tiles SET log_odds = x'0102' WHERE x = 3 AND y = 3",
                                  "UPDATE tiles SET log_odds = 7 WHERE x = 3 AND y = 3",
                                  "UPDATE tiles SET log_odds = x'7f' WHERE x = 3 AND y = 3",
                                  "UPDATE tiles SET rooms = x'09000000' WHERE x = 3 AND y = 3",
                                  "UPDATE tiles SET rooms = zeroblob(5) WHERE x = 3 AND y = 3",
                                  "UPDATE tiles SET x = 99999999999 WHERE x = 3 AND y = 3",
                                  "UPDATE tiles SET x = 100000 WHERE x = 3 AND y = 3",
                                  "UPDATE rooms SET high_x = 1000000",
                                  "UPDATE rooms SET announced_m2 = 'wide'",
                                  "UPDATE rooms SET announced_m2 = 9e999",
                                  "UPDATE rooms SET merge_group = -1",
                                  "DELETE FROM rooms",
                                  "DELETE FROM meta WHERE key = 'next_id'",
                                  "UPDATE meta SET value = 0 WHERE key = 'next_id'",
                                  "UPDATE meta SET value = 31 WHERE key = 'root_level'",
                                  "UPDATE meta SET value = 1 WHERE key = 'root_x'",
                                  "UPDATE meta SET value = 268435456 WHERE key = 'high_x'",
                                  "UPDATE meta SET value = -1 WHERE key = 'num_done'",
                                  "UPDATE meta SET value = 1e300 WHERE key = 'resolution_m'",
                                  "UPDATE options SET value = 'nan' WHERE name = 'door_width'",
                                  "INSERT INTO changes VALUES(0, 0, 100)",
                                  "INSERT INTO split_lines VALUES(1, 0, 0, 100000000, 0)"}) {
        io::write_file_atomically(path, good);
        Database(path, Access::write).run(sql);
        const std::string error =
            error_of([&] { static_cast<void>(Project(path, Access::read).follower()); });
        EXPECT_THAT(error, HasSubstr("p.quadcut: ")) << sql;
    }
}

TEST(Project, OptionsThatAreNoneAnyMoreAreReadOver) {
    const ScratchFolder folder;
    const auto path = project_of_two_rooms(folder);
    Database(path, Access::write)
        .run(
            "INSERT INTO options VALUES('rooms.fuse', 'model'), ('rooms.furniture', 'off_wall'), "
            "('rooms.min_ratio', '0.6')");
    EXPECT_EQ(Project(path, Access::write).follower().num_rooms(), 2U);
    for (const auto& [name, value, words] :
         {std::array{"rooms.fuse", "ratio",
                     "was begun with rooms.fuse = ratio, which is no choice"},
          std::array{"rooms.furniture", "reach", "expected off_wall; 'quadcut follow LOG -o DIR"},
          std::array{"rooms.pieces", "unsnapped", "expected basins or spectral"},
          std::array{"rooms.other", "1", "unknown option 'rooms.other'"}}) {
        const std::string row = std::string("VALUES('") + name + "', '" + value + "')";
        const std::filesystem::path file = folder.path() / name;
        std::filesystem::copy_file(path, file);
        Database(file, Access::write).run("REPLACE INTO options " + row);
        EXPECT_THAT(error_of([&file] { Project(file, Access::read); }),
                    testing::AllOf(HasSubstr(name), HasSubstr(words)));
    }
}

TEST(Project, DamagedBytesAreAnErrorOrNoHarm) {
    const ScratchFolder folder;
    const auto path = project_of_two_rooms(folder);
    const std::string good = io::read_file(path);
    Random random(3);
    int num_errors = 0;
    for (int i = 0; i < 60; ++i) {
        std::string bad = good;
        if (i % 3 == 0) bad.resize(random.below(bad.size()));
        for (int k = 0; k < 40 && !bad.empty(); ++k) {
            bad[random.below(bad.size())] = static_cast<char>(random.below(256));
        }
        io::write_file_atomically(path, bad);
        const std::string error = error_of([&] {
            Project project(path, Access::write);
            Follower follower = project.follower();
            project.save(follower, project.position());
        });
        if (error != "no error") ++num_errors;
        std::filesystem::remove(path.string() + "-wal");
        std::filesystem::remove(path.string() + "-shm");
    }
    EXPECT_GT(num_errors, 20);
}

TEST(Project, OneProgramWritesAtATimeOthersRead) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    Project writer = Project::create(path, {}, some_log());
    EXPECT_THAT(error_of([&] { Project(path, Access::write); }),
                HasSubstr("another program is writing"));
    const Project reader(path, Access::read);
    EXPECT_EQ(reader.follower().num_rooms(), 0U);
    Follower follower = writer.follower();
    follower.update_cells(test::bare_hall());
    writer.save(follower, some_log());
    EXPECT_EQ(Project(path, Access::read).follower().num_rooms(), 1U);
    EXPECT_THAT(error_of([&] { Project(path, Access::write); }),
                HasSubstr("another program is writing"));
}

TEST(Project, AFullDiskLeavesWhatWasSaved) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    {
        Project project = Project::create(path, {}, some_log());
        Follower follower = project.follower();
        follower.update_cells(test::bare_hall());
        project.save(follower, some_log());
        project.limit_pages(1);
        follower.update_cells(Raster<CellState>({300, 0}, 800, 800, CellState::free));
        EXPECT_THAT(error_of([&] { project.save(follower, some_log()); }),
                    HasSubstr("no space is left; the file holds what was saved before"));
    }
    const Project project(path, Access::read);
    EXPECT_EQ(project.integrity(), "ok");
    EXPECT_EQ(project.follower().num_rooms(), 1U);
    EXPECT_EQ(project.follower().map().state({500, 400}), CellState::unknown);
}

}  // namespace
}  // namespace quadcut::store
