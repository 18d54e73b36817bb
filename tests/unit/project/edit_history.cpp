// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/edit_history.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/file.hpp"
#include "project/project.hpp"
#include "project/project_file.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::project {
namespace {

using io::test::error_of;
using io::test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;

/// A project of two rooms: 1 on the left, 2 on the right.
std::filesystem::path two_rooms(const ScratchFolder& folder) {
    const auto path = folder.path() / "p.quadcut";
    Project project = Project::create(path, {});
    project.add(test::hall_with_wall());
    project.save();
    return path;
}

/// Opens the project anew, does something with it, and saves.
template <typename Action>
void with_project(const std::filesystem::path& path, const Action& action) {
    Project project = Project::open(path, Access::write);
    action(project);
    project.save();
}

void rename(const std::filesystem::path& path, std::uint32_t room, const std::string& name) {
    with_project(path, [&](Project& project) { project.edit(test::rename(RoomId{room}, name)); });
}

void merge(const std::filesystem::path& path) {
    with_project(path, [](Project& project) { project.edit(test::merge(RoomId{1}, RoomId{2})); });
}

void undo(const std::filesystem::path& path) {
    with_project(path, [](Project& project) { project.undo(); });
}

void redo(const std::filesystem::path& path) {
    with_project(path, [](Project& project) { project.redo(); });
}

std::shared_ptr<const Snapshot> building(const std::filesystem::path& path) {
    return Project::open(path, Access::read).snapshot();
}

std::vector<EditState> states(const std::filesystem::path& path) {
    std::vector<EditState> states;
    for (const EditRecord& record : Project::open(path, Access::read).history()) {
        states.push_back(record.state);
    }
    return states;
}

std::string name_of(const std::filesystem::path& path, std::uint32_t room) {
    return building(path)->followed()->rooms.at(room).name;
}

std::string integrity(const std::filesystem::path& path) {
    return ProjectFile(path, Access::read).integrity();
}

TEST(EditHistory, UndoAndRedoSurviveARestart) {
    const ScratchFolder folder;
    const auto path = two_rooms(folder);
    const auto labels = [&] { return building(path)->rooms().labels.values; };
    const auto before = labels();
    rename(path, 2, "Store");
    rename(path, 1, "Kitchen");
    merge(path);
    const auto after = labels();
    EXPECT_EQ(building(path)->num_rooms(), 1U);
    undo(path);
    EXPECT_EQ(labels(), before);
    EXPECT_EQ(name_of(path, 2), "Store");
    undo(path);
    EXPECT_EQ(name_of(path, 1), "") << "the default name";
    EXPECT_THAT(states(path), ElementsAre(EditState::done, EditState::undone, EditState::undone));
    redo(path);
    EXPECT_EQ(name_of(path, 1), "Kitchen");
    redo(path);
    EXPECT_EQ(labels(), after);
    EXPECT_THAT(error_of([&] { redo(path); }), HasSubstr("nothing to redo"));
    for (int i = 0; i < 3; ++i) undo(path);
    EXPECT_THAT(error_of([&] { undo(path); }), HasSubstr("nothing to undo"));
    EXPECT_EQ(labels(), before);
}

TEST(EditHistory, ANewEditDropsWhatWasUndone) {
    const ScratchFolder folder;
    const auto path = two_rooms(folder);
    rename(path, 1, "One");
    rename(path, 1, "Two");
    rename(path, 1, "Three");
    undo(path);
    undo(path);
    rename(path, 1, "Four");
    EXPECT_THAT(error_of([&] { redo(path); }), HasSubstr("nothing to redo"));
    undo(path);
    EXPECT_EQ(name_of(path, 1), "One");
    redo(path);
    EXPECT_EQ(name_of(path, 1), "Four");
    EXPECT_THAT(states(path), ElementsAre(EditState::done, EditState::dropped, EditState::dropped,
                                          EditState::done));
    undo(path);
    undo(path);
    EXPECT_EQ(name_of(path, 1), "");
}

TEST(EditHistory, WhatCannotBeUndoneIsSaidAndNothingChanges) {
    const ScratchFolder folder;
    const auto path = two_rooms(folder);
    merge(path);
    with_project(path, [](Project& project) {
        project.add(Raster<CellState>({100, 10}, 150, 100, CellState::occupied));
    });
    EXPECT_THAT(error_of([&] { undo(path); }),
                HasSubstr("edit 1 cannot be undone after what was seen since: the floor of one"));
    EXPECT_THAT(states(path), ElementsAre(EditState::done));
    EXPECT_EQ(integrity(path), "ok");
}

/// A file as version 1 wrote it, with an edit.
std::filesystem::path project_of_version_1(const ScratchFolder& folder) {
    const auto path = two_rooms(folder);
    Database database(path, Access::write);
    for (const char* const table :
         {"door_lines", "undo", "undo_cells", "undo_lines", "undo_rooms"}) {
        database.run(std::string("DROP TABLE ") + table);
    }
    database.run(
        "INSERT INTO edits(scan, kind, room, other, name, from_x, from_y, to_x, to_y) "
        "VALUES(0, 'rename', 1, 0, 'Kitchen', 0, 0, 0, 0)");
    database.run("UPDATE rooms SET name = 'Kitchen' WHERE id = 1");
    database.run(
        "DELETE FROM options WHERE name LIKE 'follow.%' OR name LIKE 'scan.%' OR name = "
        "'resolution'");
    database.run("DELETE FROM meta WHERE key = 'next_door_id' OR key = 'revision'");
    database.run(
        "INSERT INTO meta VALUES('resolution_m', 0.05), ('min_change_m2', 2.5), "
        "('max_wait_m2_scans', 100.0), ('first_cut_m2', 10.0), ('min_patch_m2', 0.05)");
    database.run("DELETE FROM meta WHERE key IN ('next_door_id', 'revision')");
    database.run("PRAGMA user_version=1");
    return path;
}

TEST(EditHistory, AProjectOfVersion1IsReadAndBecomesOneOfThisWhenItIsSaved) {
    const ScratchFolder folder;
    const auto path = project_of_version_1(folder);
    EXPECT_THAT(states(path), ElementsAre(EditState::fixed));
    EXPECT_EQ(name_of(path, 1), "Kitchen");
    EXPECT_EQ(ProjectFile(path, Access::read).follower({}).state().doors.size(), 1U);
    EXPECT_EQ(Database(path, Access::read).pragma("user_version"), 1);
    EXPECT_EQ(Project::open(path, Access::read).options().min_change_m2, 2.5);
    static_cast<void>(Project::open(path, Access::write));
    EXPECT_EQ(Database(path, Access::read).pragma("user_version"), 1) << "not saved";
    rename(path, 2, "Store");
    EXPECT_EQ(Database(path, Access::read).pragma("user_version"), 4);
    EXPECT_EQ(Project::open(path, Access::read).options().min_change_m2, 2.5);
    EXPECT_THAT(states(path), ElementsAre(EditState::fixed, EditState::done));
    undo(path);
    EXPECT_THAT(error_of([&] { undo(path); }), HasSubstr("edit 1 was made by a version"));
    EXPECT_EQ(name_of(path, 1), "Kitchen");
    EXPECT_EQ(integrity(path), "ok");
}

TEST(EditHistory, RowsThatCannotBeAreRefused) {
    const ScratchFolder folder;
    const auto path = two_rooms(folder);
    merge(path);
    const std::string good = io::read_file(path);
    for (const std::string sql :
         {"UPDATE undo SET state = 'perhaps'", "UPDATE undo SET border = 3",
          "UPDATE undo SET border = 'join'", "UPDATE undo SET border = 'wall'",
          "UPDATE undo_rooms SET room = -1", "UPDATE undo_rooms SET name = x'00'",
          "UPDATE undo_rooms SET locked = 2", "UPDATE undo_cells SET x = 1e9",
          "UPDATE undo_cells SET x = x + 100000", "DELETE FROM undo_cells",
          "UPDATE undo_cells SET cells = 'all'", "UPDATE edits SET room = 4711",
          "UPDATE edits SET other = 1", "UPDATE edits SET other = 60000",
          "UPDATE edits SET kind = NULL", "UPDATE edits SET kind = 'paint'",
          "UPDATE edits SET from_x = 1e300",
          "INSERT INTO undo_lines VALUES(1, 0, 0, 99999999999, 0)",
          "INSERT INTO undo_lines VALUES(1, 20, 20, 100000000, 20)"}) {
        io::write_file_atomically(path, good);
        Database(path, Access::write).run(sql);
        EXPECT_NE(error_of([&] { undo(path); }), "no error") << sql;
    }
    // Names that nobody could give are read as they are.
    io::write_file_atomically(path, good);
    Database(path, Access::write).run("UPDATE undo_rooms SET name = CAST(x'ff0a1b' AS TEXT)");
    undo(path);
    static_cast<void>(building(path)->rooms());
}

}  // namespace
}  // namespace quadcut::project
