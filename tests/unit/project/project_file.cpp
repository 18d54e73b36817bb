// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project_file.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/file.hpp"
#include "project/project.hpp"
#include "quadcut/base/random.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::project {
namespace {

using io::test::error_of;
using io::test::ScratchFolder;
using testing::HasSubstr;

std::filesystem::path project_of_two_rooms(const ScratchFolder& folder) {
    const auto path = folder.path() / "p.quadcut";
    Project project = Project::create(path, {});
    project.add(test::hall_with_wall());
    project.save();
    return path;
}

std::size_t num_rooms_in(const std::filesystem::path& path) {
    return Project::open(path, Access::read).state().num_rooms;
}

TEST(ProjectFile, WhatIsNoProjectIsRefused) {
    const ScratchFolder folder;
    const auto open = [&](const std::filesystem::path& path) {
        return error_of([&] { static_cast<void>(Project::open(path, Access::write)); });
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
    static_cast<void>(Project::create(path, {}));
    EXPECT_EQ(open(path), "no error");
    Database(path, Access::write).run("CREATE TABLE extra(x)");
    EXPECT_THAT(open(path), HasSubstr("its tables are not"));
    Database(path, Access::write).run("DROP TABLE extra; PRAGMA user_version=5");
    EXPECT_THAT(open(path), HasSubstr("format version 5: expected 1 to 4; a newer quadcut"));
}

TEST(ProjectFile, RowsThatCannotBeAreRefused) {
    const ScratchFolder folder;
    const auto path = project_of_two_rooms(folder);
    const std::string good = io::read_file(path);
    for (const std::string sql :
         {"UPDATE tiles SET log_odds = x'0102' WHERE x = 3 AND y = 3",
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
          "UPDATE options SET value = '1e300' WHERE name = 'resolution'",
          "UPDATE options SET value = 'nan' WHERE name = 'door_width'",
          "INSERT INTO changes VALUES(0, 0, 100)",
          "INSERT INTO covisibility VALUES(1, 999, 1.0)",
          "INSERT OR REPLACE INTO covisibility VALUES(2, 1, 1.0)",
          "INSERT OR REPLACE INTO covisibility VALUES(1, 1, -1.0)",
          "INSERT OR REPLACE INTO covisibility VALUES(1, 1, 1e308)",
          "INSERT INTO poses(x, y, yaw_rad) WITH RECURSIVE n(i) AS (SELECT 1 "
          "UNION ALL SELECT i + 1 FROM n WHERE i < 10000) SELECT 0, 0, 0 "
          "FROM n",
          "INSERT INTO poses VALUES(1000, 'here', 0, 0)",
          "INSERT INTO poses VALUES(1000, 0, 1e30, 0)",
          "INSERT INTO split_lines VALUES(1, 0, 0, 100000000, 0)"}) {
        io::write_file_atomically(path, good);
        Database(path, Access::write).run(sql);
        const std::string error =
            error_of([&] { static_cast<void>(Project::open(path, Access::read)); });
        EXPECT_THAT(error, HasSubstr("p.quadcut: ")) << sql;
    }
}

TEST(ProjectFile, OptionsThatAreNoneAnyMoreAreReadOver) {
    const ScratchFolder folder;
    const auto path = project_of_two_rooms(folder);
    Database(path, Access::write)
        .run(
            "INSERT INTO options VALUES('rooms.fuse', 'model'), ('rooms.furniture', 'off_wall'), "
            "('rooms.min_ratio', '0.6'), ('rooms.laplacian', 'area'), "
            "('rooms.max_eigenvalue', '0.8'), ('rooms.full_clearance', '1.5'), "
            "('paper.components', 'null_space')");
    EXPECT_EQ(num_rooms_in(path), 2U);
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
        EXPECT_THAT(error_of([&file] { static_cast<void>(Project::open(file, Access::read)); }),
                    testing::AllOf(HasSubstr(name), HasSubstr(words)));
    }
}

TEST(ProjectFile, DamagedBytesAreAnErrorOrNoHarm) {
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
            Project project = Project::open(path, Access::write);
            project.save();
        });
        if (error != "no error") ++num_errors;
        std::filesystem::remove(path.string() + "-wal");
        std::filesystem::remove(path.string() + "-shm");
    }
    EXPECT_GT(num_errors, 20);
}

TEST(ProjectFile, OneProgramWritesAtATimeOthersRead) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    Project writer = Project::create(path, {});
    const auto write = [&] { static_cast<void>(Project::open(path, Access::write)); };
    EXPECT_THAT(error_of(write), HasSubstr("another program is writing"));
    EXPECT_EQ(num_rooms_in(path), 0U);
    writer.add(test::bare_hall());
    writer.save();
    EXPECT_EQ(num_rooms_in(path), 1U);
    EXPECT_THAT(error_of(write), HasSubstr("another program is writing"));
}

TEST(ProjectFile, AFullDiskLeavesWhatWasSaved) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    {
        ProjectFile file = ProjectFile::create(path, {}, {});
        Follower follower = file.follower({});
        const auto save = [&] {
            file.save(follower.state(), {follower.changes_since(0).tiles, "", {}}, {});
        };
        follower.update_cells(test::bare_hall());
        save();
        file.limit_pages(1);
        follower.update_cells(Raster<CellState>({300, 0}, 800, 800, CellState::free));
        EXPECT_THAT(error_of(save),
                    HasSubstr("no space is left; the file holds what was saved before"));
        EXPECT_THAT(error_of(save), HasSubstr("a save has failed; it holds what was saved before"));
    }
    const ProjectFile file(path, Access::read);
    EXPECT_EQ(file.integrity(), "ok");
    EXPECT_EQ(file.follower({}).num_rooms(), 1U);
    EXPECT_EQ(file.follower({}).map().state({500, 400}), CellState::unknown);
}

}  // namespace
}  // namespace quadcut::project
