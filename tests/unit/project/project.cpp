// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/option_text.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"
#include "tests/unit/spectral/fake_accelerator.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
using io::test::ScratchFolder;
using test::scans_in;
using test::small_building;
using testing::HasSubstr;

ScanPosition some_log() {
    ScanPosition position;
    position.source = "robot.log";
    position.source_hash = 0xfedcba9876543210U;
    return position;
}

TEST(Project, GoesOnFromWhatWasSaved) {
    const ScratchFolder folder;
    const std::vector<Scan> scans = scans_in(small_building(3));
    const auto path = folder.path() / "p.quadcut";
    Project whole = Project::in_memory({}, some_log());
    std::size_t at = 0;
    {
        Project project = Project::create(path, {}, some_log());
        for (; at < scans.size() / 2; ++at) {
            whole.add_next(scans[at]);
            project.add_next(scans[at]);
            if (at % 50 == 0) project.save();
        }
        project.save();
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"p.quadcut"});
    Project project = Project::open(path, Access::write);
    EXPECT_EQ(project.position()->num_done, at);
    EXPECT_EQ(project.position()->source_hash, some_log().source_hash);
    const std::string lines = project.snapshot()->updates();
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), static_cast<std::ptrdiff_t>(at));
    for (; at < scans.size(); ++at) {
        const FollowUpdate a = whole.add_next(scans[at]).value();
        const FollowUpdate b = project.add_next(scans[at]).value();
        ASSERT_EQ(a.nodes_touched, b.nodes_touched) << at;
        ASSERT_EQ(a.ps, b.ps) << at;
        ASSERT_EQ(a.graph_nodes, b.graph_nodes) << at;
        ASSERT_EQ(a.events.size(), b.events.size()) << at;
    }
    whole.finish();
    project.finish();
    const Segmentation& rooms = whole.snapshot()->rooms();
    EXPECT_EQ(rooms.labels.values, project.snapshot()->rooms().labels.values);
    EXPECT_EQ(rooms.next_id, project.snapshot()->rooms().next_id);
    EXPECT_EQ(whole.snapshot()->way().size(), scans.size());
    EXPECT_EQ(whole.snapshot()->poses(), project.snapshot()->poses());
    EXPECT_EQ(whole.snapshot()->followed()->covisibility,
              project.snapshot()->followed()->covisibility);
    EXPECT_FALSE(whole.snapshot()->followed()->covisibility.scans.empty());
}

TEST(Project, NeedsNoLog) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    const std::vector<Scan> scans = scans_in(small_building(3));
    {
        Project project = Project::create(path, {});
        for (std::size_t i = 0; i < 40; ++i) project.add(scans[i]);
        project.finish();
    }
    Project project = Project::open(path, Access::write);
    EXPECT_FALSE(project.position());
    EXPECT_EQ(project.state().num_scans, 40U);
    project.set_position(some_log());
    project.save();
    EXPECT_THAT(error_of([&] { static_cast<void>(Project::open_or_create(path, {}, some_log())); }),
                HasSubstr("another program"));
}

TEST(Project, AMemoryBecomesAFile) {
    const ScratchFolder folder;
    Project project = Project::in_memory({});
    project.add(test::hall_with_wall());
    project.edit(test::rename(RoomId{1}, "Kitchen"));
    project.save();
    const auto path = folder.write("p.quadcut", project.file_bytes());
    const Project saved = Project::open(path, Access::read);
    EXPECT_EQ(saved.snapshot()->followed()->rooms.at(1).name, "Kitchen");
    EXPECT_EQ(saved.history().size(), 1U);
    EXPECT_EQ(saved.snapshot()->updates(), project.snapshot()->updates());
    project.undo();
    EXPECT_EQ(project.snapshot()->followed()->rooms.at(1).name, "");
}

TEST(Project, AScanThatCannotBeUsedIsLeftOutAndCounted) {
    Project project = Project::in_memory({}, some_log());
    const std::vector<Scan> scans = scans_in(small_building(3));
    Scan bad = scans[0];
    bad.world_from_sensor.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(project.add_next(scans[0], "line 7"));
    EXPECT_FALSE(project.add_next(bad, "line 8"));
    EXPECT_FALSE(project.add_next(bad, "line 9"));
    EXPECT_EQ(project.position()->num_done, 3U);
    ASSERT_EQ(warnings_of(*project.position()).size(), 1U);
    EXPECT_THAT(warnings_of(*project.position())[0],
                HasSubstr("scans left out: 2; the first: line 8: "));
    EXPECT_EQ(project.state().revision, 1U) << "nothing has changed";
    EXPECT_NE(error_of([&] { project.add(bad); }), "no error");
}

TEST(Project, BelongsToOneSourceAndItsOptions) {
    const ScratchFolder folder;
    const auto path = folder.path() / "in/new/p.quadcut";
    const auto begin = [&](const FollowOptions& options, const ScanPosition& source) {
        return error_of([&] { static_cast<void>(Project::open_or_create(path, options, source)); });
    };
    EXPECT_EQ(begin({}, some_log()), "no error");
    EXPECT_EQ(begin({}, some_log()), "no error");
    ScanPosition other = some_log();
    other.source_hash = 1;
    EXPECT_THAT(begin({}, other), HasSubstr("p.quadcut: follows another log, robot.log, or had"));
    FollowOptions options;
    options.resolution_m = 0.1;
    EXPECT_THAT(begin(options, some_log()), HasSubstr("was begun with resolution = 0.05"));
    options = {};
    options.segment.seed = 2;
    EXPECT_THAT(begin(options, some_log()), HasSubstr("was begun with seed = 1"));
    const auto without = folder.path() / "without.quadcut";
    static_cast<void>(Project::create(without, {}));
    EXPECT_THAT(
        error_of([&] { static_cast<void>(Project::open_or_create(without, {}, some_log())); }),
        HasSubstr("without.quadcut: follows no log"));
}

TEST(Project, KeepsAllOptionsThatDecideTheResult) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    FollowOptions options;
    options.resolution_m = 1.0 / 30.0;
    options.integrate.miss = -2;
    options.integrate.usable_range_m = 12.5;
    options.min_change_m2 = 3.0;
    options.segment.rooms.door_width_m = 2.0;
    options.segment.seed = 7;
    static_cast<void>(Project::create(path, options));
    FollowOptions kept = Project::open(path, Access::read).options();
    const std::vector<OptionField> had = option_fields(options);
    const std::vector<OptionField> has = option_fields(kept);
    for (std::size_t i = 0; i < had.size(); ++i) {
        EXPECT_EQ(io::option_text(has[i]), io::option_text(had[i])) << had[i].name;
    }
}

TEST(Project, UsesTheDeviceThatItIsGiven) {
    const ScratchFolder folder;
    FollowOptions options;
    options.segment.preset = Preset::paper;
    const auto path = folder.path() / "p.quadcut";
    static_cast<void>(Project::create(path, options));
    test::FakeAccelerator device(true);
    Project::open(path, Access::write, RunOptions{1, &device}).add(test::bare_hall());
    EXPECT_GT(device.num_calls, 0);
}

TEST(Project, EditsAreRowsThatStay) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    {
        Project project = Project::create(path, {});
        project.add(test::bare_hall());
        const RoomId hall = project.snapshot()->room_at({9.0, 3.0});
        EXPECT_EQ(project.edit(test::rename(hall, "  Hall ")).edit.name, "Hall");
        EXPECT_EQ(project.edit(test::split({4.0, 1.0}, {4.0, 5.0})).number, 2);
        project.save();
    }
    Project project = Project::open(path, Access::write);
    ASSERT_EQ(project.history().size(), 2U);
    EXPECT_EQ(project.history()[0].edit.name, "Hall");
    const Edit split = project.history()[1].edit;
    EXPECT_EQ(split.kind, EditKind::split);
    EXPECT_NEAR(split.from.x, 4.0, 0.03);
    EXPECT_EQ(project.snapshot()->followed()->split_lines.size(), 1U);
    project.add(Raster<CellState>({150, 60}, 12, 12, CellState::occupied));
    EXPECT_EQ(project.state().num_rooms, 2U) << "the line is still a cut";
    EXPECT_EQ(project.snapshot()->followed()->rooms.at(1).name, "Hall");
}

TEST(Project, ARefusedEditChangesNothing) {
    Project project = Project::in_memory({});
    project.add(test::hall_with_wall());
    const auto before = project.snapshot();
    for (const Edit& edit : {test::rename(RoomId{1}, "\n"), test::rename(RoomId{9}, "Hall"),
                             test::merge(RoomId{1}, RoomId{1}), test::unlock(RoomId{1})}) {
        EXPECT_NE(error_of([&] { project.edit(edit); }), "no error");
    }
    EXPECT_THAT(error_of([&] { project.undo(); }), HasSubstr("nothing to undo"));
    EXPECT_EQ(project.snapshot(), before);
    EXPECT_TRUE(project.history().empty());
}

TEST(Project, WhatIsReadOnlyIsNotChanged) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    static_cast<void>(Project::create(path, {}));
    Project project = Project::open(path, Access::read);
    EXPECT_THROW(project.add(test::bare_hall()), std::logic_error);
    EXPECT_THROW(project.save(), std::logic_error);
    EXPECT_EQ(project.snapshot()->num_rooms(), 0U);
}

TEST(Project, ASnapshotIsMadeOnceARevisionAndNeverChanges) {
    Project project = Project::in_memory({});
    project.add(test::bare_hall());
    const auto one = project.snapshot();
    EXPECT_EQ(one, project.snapshot());
    EXPECT_EQ(one->num_rooms(), 1U);
    project.add(test::hall_with_wall());
    const auto two = project.snapshot();
    EXPECT_NE(one, two);
    EXPECT_LT(one->revision(), two->revision());
    EXPECT_EQ(two->num_rooms(), 2U);
    EXPECT_EQ(one->rooms().rooms.size(), 1U) << "asked for late";
    const std::string lines = one->updates();
    EXPECT_EQ(two->updates().substr(0, lines.size()), lines);
    EXPECT_GT(two->updates().size(), lines.size());
    project.set_position(some_log());
    EXPECT_EQ(two, project.snapshot()) << "the building is as it was";
}

TEST(Project, FinishingIsDoneOnceUnlessMoreIsSeen) {
    Project project = Project::in_memory({});
    const auto num_lines = [&] {
        const std::string lines = project.snapshot()->updates();
        return std::count(lines.begin(), lines.end(), '\n');
    };
    project.add(test::bare_hall());
    project.finish();
    project.finish();
    EXPECT_EQ(num_lines(), 2);
    project.add(test::hall_with_wall());
    project.finish();
    EXPECT_EQ(num_lines(), 4);
}

TEST(Project, ListenersAreToldWhatChangedSinceTheyAskedLast) {
    const ScratchFolder folder;
    const auto path = folder.path() / "p.quadcut";
    std::size_t num_tiles = 0;
    {
        Project project = Project::create(path, {});
        EXPECT_EQ(project.changes_since(0).size(), 0U);
        project.add(test::hall_with_wall());
        const Changes seen = project.changes_since(0);
        EXPECT_EQ(seen.revision, project.state().revision);
        EXPECT_EQ(seen.rooms, (std::vector{RoomId{1}, RoomId{2}}));
        num_tiles = seen.tiles.size();
        EXPECT_GT(num_tiles, 400U);
        project.edit(test::rename(RoomId{2}, "Hall"));
        const Changes renamed = project.changes_since(seen.revision);
        EXPECT_GT(renamed.revision, seen.revision);
        EXPECT_EQ(renamed.rooms, std::vector{RoomId{2}});
        EXPECT_TRUE(renamed.tiles.empty());
        EXPECT_EQ(project.changes_since(renamed.revision).size(), 0U);
        project.save();
    }
    const Project project = Project::open(path, Access::read);
    for (const std::uint64_t revision : {std::uint64_t{0}, std::uint64_t{1000}}) {
        EXPECT_EQ(project.changes_since(revision).tiles.size(), num_tiles) << "of another life";
    }
    EXPECT_EQ(project.changes_since(project.state().revision).size(), 0U);
}

}  // namespace
}  // namespace quadcut
