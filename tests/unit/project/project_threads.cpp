// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "io/file.hpp"
#include "project/project.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kNumScans = 90;
constexpr std::size_t kNumReaders = 4;

/// All that is cheap to ask, in one number.
std::uint64_t digest_of(const Snapshot& building) {
    const GridMap& map = building.map();
    const std::string updates = building.updates();
    std::string bytes = std::to_string(building.followed()->num_scans) + " " +
                        std::to_string(std::count(updates.begin(), updates.end(), '\n')) + " ";
    for (const auto& [id, room] : building.followed()->rooms) {
        bytes += std::to_string(id) + room.name + (room.is_locked ? "!" : "") +
                 std::to_string(room.num_cells) + " ";
    }
    for (std::size_t i = 0; i < map.states.values.size(); i += 7) {
        const Cell cell = map.states.cell(i);
        const Point middle{(cell.x + 0.5) * map.resolution_m, (cell.y + 0.5) * map.resolution_m};
        const RoomId room = building.room_at(transform(map.map_from_image, middle));
        bytes += static_cast<char>(map.states.values[i]);
        bytes += static_cast<char>(index(room));
    }
    return io::hash_bytes(bytes);
}

/// Labels, rooms and doors of one moment belong together.
void expect_whole(const Snapshot& building) {
    const Segmentation& rooms = building.rooms();
    ASSERT_EQ(rooms.rooms.size(), building.num_rooms());
    ASSERT_EQ(rooms.labels.values.size(), building.map().states.values.size());
    std::vector<std::size_t> num_cells(rooms.rooms.size() + 1);
    for (const std::uint16_t label : rooms.labels.values) {
        ASSERT_LE(label, rooms.rooms.size());
        ++num_cells[label];
    }
    const double cell_m2 = building.map().resolution_m * building.map().resolution_m;
    for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
        const Room& room = rooms.rooms[i];
        EXPECT_NEAR(room.area_m2, static_cast<double>(num_cells[i + 1]) * cell_m2, 1e-6);
        EXPECT_EQ(building.room_at(room.label_point), room.id);
        EXPECT_EQ(building.find_room(room.name), room.id);
    }
    for (const Door& door : rooms.doors) {
        for (const RoomId side : {door.a, door.b}) {
            EXPECT_TRUE(building.followed()->rooms.contains(static_cast<std::uint32_t>(side)));
        }
    }
}

/// A robot's scans, and what people change meanwhile; `after_each` is called between.
template <typename AfterEach>
void live(Project& project, const std::vector<Scan>& scans, const AfterEach& after_each) {
    for (std::size_t i = 0; i < kNumScans; ++i) {
        project.add(scans[i]);
        after_each();
        if (i % 20 != 19) continue;
        const RoomId room{project.snapshot()->followed()->rooms.begin()->first};
        project.edit(test::rename(room, "Room of scan " + std::to_string(i)));
        after_each();
        project.edit(test::lock(room));
        after_each();
        project.undo();
        after_each();
    }
    project.finish();
    after_each();
}

TEST(ProjectThreads, ReadersSeeWhatOneThreadAloneHadAtThatRevision) {
    const std::vector<Scan> scans = test::scans_in(test::small_building(3));
    std::map<std::uint64_t, std::uint64_t> expected;
    {
        Project alone = Project::in_memory({});
        live(alone, scans, [&] {
            const auto building = alone.snapshot();
            expected[building->revision()] = digest_of(*building);
        });
    }
    const io::test::ScratchFolder folder;
    Project project = Project::create(folder.path() / "p.quadcut", {});
    std::atomic<bool> is_over = false;
    std::atomic<std::size_t> num_seen = 0;
    std::vector<std::thread> readers;
    for (std::size_t reader = 0; reader < kNumReaders; ++reader) {
        readers.emplace_back([&, reader] {
            std::uint64_t last = 0;
            for (std::size_t i = reader; !is_over; ++i) {
                const auto building = project.snapshot(last);
                EXPECT_GE(building->revision(), last);
                EXPECT_LE(building->revision(), project.state().revision);
                if (building->revision() == 0 || building->revision() == last) {
                    std::this_thread::yield();
                    continue;
                }
                last = building->revision();
                ++num_seen;
                EXPECT_EQ(digest_of(*building), expected.at(last)) << last;
                EXPECT_EQ(building->way().size(), building->followed()->num_scans);
                if (i % 8 == 0) expect_whole(*building);
                EXPECT_GE(project.changes_since(last).revision, last);
                EXPECT_LE(project.history().size(), 2 * kNumScans);
            }
        });
    }
    live(project, scans, [] {});
    is_over = true;
    for (std::thread& reader : readers) reader.join();
    EXPECT_GT(num_seen, kNumReaders) << "they looked while it went on";
    EXPECT_EQ(digest_of(*project.snapshot()), expected.rbegin()->second);
    expect_whole(*project.snapshot());
}

/// Who changes something in the midst of others' changes has his turn, and finds it made.
TEST(ProjectThreads, ChangesOfSeveralThreadsAreMadeOneAfterTheOther) {
    Project project = Project::in_memory({});
    project.add(test::hall_with_wall());
    const std::uint64_t before = project.state().revision;
    constexpr int kNumEdits = 20;
    std::atomic<int> num_editing = 2;
    std::atomic<std::uint64_t> num_patches = 0;
    std::thread robot([&] {
        while (num_editing > 0) {
            const bool is_even = num_patches++ % 2 == 0;
            project.add(
                Raster<CellState>({30, 30}, 8, 8, is_even ? CellState::occupied : CellState::free));
        }
    });
    std::vector<std::thread> people;
    for (const std::uint32_t room : {1U, 2U}) {
        people.emplace_back([&project, &num_editing, room] {
            for (int i = 0; i < kNumEdits; ++i) {
                const std::string name = std::to_string(i) + " of " + std::to_string(room);
                project.edit(test::rename(RoomId{room}, name));
                const auto building = project.snapshot(project.state().revision);
                EXPECT_EQ(building->followed()->rooms.at(room).name, name);
            }
            --num_editing;
        });
    }
    for (std::thread& person : people) person.join();
    robot.join();
    EXPECT_EQ(project.state().revision, before + 2 * kNumEdits + num_patches);
    EXPECT_EQ(project.history().size(), 2U * kNumEdits);
    for (std::size_t i = 0; i < project.history().size(); ++i) {
        EXPECT_EQ(project.history()[i].number, static_cast<std::int64_t>(i + 1));
    }
}

/// What is made when it is first asked for is made once, whoever asks.
TEST(ProjectThreads, ManyHoldOneSnapshot) {
    Project project = Project::in_memory({});
    project.add(test::hall_with_wall());
    const auto building = project.snapshot();
    std::vector<const Segmentation*> asked(50);
    std::vector<std::thread> readers;
    for (const Segmentation*& rooms : asked) {
        readers.emplace_back([&project, &rooms, held = project.snapshot()] {
            EXPECT_EQ(held, project.snapshot());
            rooms = &held->rooms();
            EXPECT_EQ(held->place_of({9.0, 3.0}).room, RoomId{2});
        });
    }
    for (std::thread& reader : readers) reader.join();
    EXPECT_TRUE(std::all_of(asked.begin(), asked.end(), [&](const Segmentation* rooms) {
        return rooms == &building->rooms();
    }));
}

}  // namespace
}  // namespace quadcut
