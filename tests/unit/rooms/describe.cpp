// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/describe.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

constexpr double kResolutionM = 0.1;

/// A plan of regions in metres, painted one over the other; 0 is no room.
class Regions {
public:
    Regions(double width_m, double height_m) : labels_({0, 0}, cells(width_m), cells(height_m)) {}

    void paint(std::uint32_t label, double x0, double y0, double x1, double y1) {
        for (std::int32_t y = cells(y0); y < cells(y1); ++y) {
            for (std::int32_t x = cells(x0); x < cells(x1); ++x) labels_.at({x, y}) = label;
        }
    }
    /// A straight stretch of passage.
    void paint_strip(std::uint32_t label, Point from, Point to, double width_m) {
        const double dx = to.x - from.x;
        const double dy = to.y - from.y;
        const double length = std::hypot(dx, dy);
        for (std::size_t i = 0; i < labels_.values.size(); ++i) {
            const Cell cell = labels_.cell(i);
            const double x = (cell.x + 0.5) * kResolutionM - from.x;
            const double y = (cell.y + 0.5) * kResolutionM - from.y;
            const double along = (x * dx + y * dy) / length;
            const double across = (x * dy - y * dx) / length;
            const bool is_in = along >= -width_m / 2.0 && along <= length + width_m / 2.0;
            if (is_in && std::abs(across) <= width_m / 2.0) labels_.values[i] = label;
        }
    }
    /// The kind of room 1, with so many doors.
    [[nodiscard]] RoomKind kind(std::size_t num_doors) const { return room(num_doors).kind; }
    [[nodiscard]] Room room(std::size_t num_doors) const {
        std::uint32_t count = 1;
        for (const std::uint32_t label : labels_.values) count = std::max(count, label);
        GridMap map;
        map.resolution_m = kResolutionM;
        map.states = Raster<CellState>({0, 0}, labels_.width, labels_.height, CellState::free);
        Door door;
        door.a = RoomId{1};
        door.b = RoomId{std::max<std::uint32_t>(count, 2)};
        const std::vector<Door> doors(num_doors, door);
        const std::uint32_t num_rooms = std::max<std::uint32_t>(count, 2);
        return describe_rooms(labels_, num_rooms, map, as_it_lies(labels_.box()), doors).front();
    }

private:
    static std::int32_t cells(double metres) {
        return static_cast<std::int32_t>(std::lround(metres / kResolutionM));
    }
    Raster<std::uint32_t> labels_;
};

TEST(Describe, ATableInTheMiddleMakesNoCorridor) {
    Regions meeting_room(9.0, 7.0);
    meeting_room.paint(1, 1.0, 1.0, 8.0, 6.0);
    EXPECT_EQ(meeting_room.kind(2), RoomKind::room);
    meeting_room.paint(0, 2.3, 2.6, 6.7, 4.4);
    const Room room = meeting_room.room(2);
    EXPECT_EQ(room.kind, RoomKind::room);
    EXPECT_NEAR(room.area_m2, 35.0 - 4.4 * 1.8, 1e-9) << "of the floor, as before";
}

TEST(Describe, ShelvesMakeNoCorridorOfAShop) {
    Regions shop(14.0, 12.0);
    shop.paint(1, 1.0, 1.0, 13.0, 11.0);
    for (double x = 2.5; x < 12.0; x += 2.2) shop.paint(0, x, 2.5, x + 0.8, 9.5);
    EXPECT_EQ(shop.kind(3), RoomKind::hall);
}

TEST(Describe, ACorridorAroundRoomsStaysOne) {
    Regions ring(22.0, 22.0);
    ring.paint(1, 1.0, 1.0, 21.0, 21.0);
    ring.paint(0, 3.0, 3.0, 19.0, 19.0);
    EXPECT_EQ(ring.kind(4), RoomKind::corridor) << "around a court";
    ring.paint(2, 3.2, 3.2, 18.8, 18.8);
    EXPECT_EQ(ring.kind(4), RoomKind::corridor) << "around a block of rooms";
    Regions small(8.0, 8.0);
    small.paint(1, 1.0, 1.0, 7.0, 7.0);
    small.paint(0, 2.5, 2.5, 5.5, 5.5);
    small.paint(2, 2.7, 2.7, 5.3, 5.3);
    EXPECT_EQ(small.kind(2), RoomKind::corridor) << "a room in the middle is no table";
}

TEST(Describe, APassageOfAHundredMetresIsACorridor) {
    for (const double width_m : {1.2, 2.0, 3.3, 4.4, 5.0}) {
        for (const std::size_t num_doors : {0U, 1U, 2U, 30U}) {
            Regions straight(102.0, 7.0);
            straight.paint(1, 1.0, 1.0, 101.0, 1.0 + width_m);
            EXPECT_EQ(straight.kind(num_doors), RoomKind::corridor) << width_m;
        }
        Regions bent(70.0, 60.0);
        bent.paint_strip(1, {5.0, 5.0}, {40.0, 12.0}, width_m);
        bent.paint_strip(1, {40.0, 12.0}, {65.0, 50.0}, width_m);
        bent.paint_strip(1, {65.0, 50.0}, {40.0, 55.0}, width_m);
        EXPECT_EQ(bent.kind(1), RoomKind::corridor) << width_m;
    }
}

TEST(Describe, ALobbyOrNichesDoNotChangeWhatAPassageIs) {
    Regions passage(102.0, 14.0);
    passage.paint(1, 1.0, 6.0, 101.0, 8.5);
    for (double x = 4.0; x < 96.0; x += 8.0) passage.paint(1, x, 5.0, x + 2.0, 6.0);
    EXPECT_EQ(passage.kind(2), RoomKind::corridor) << "niches";
    passage.paint(1, 47.0, 3.0, 56.0, 12.0);
    EXPECT_EQ(passage.kind(2), RoomKind::corridor) << "a lobby of 9 x 9 m";
}

TEST(Describe, LongHallsAndRoomsKeepTheirKind) {
    Regions hall(42.0, 14.0);
    hall.paint(1, 1.0, 1.0, 41.0, 13.0);
    EXPECT_EQ(hall.kind(6), RoomKind::hall);
    Regions office(12.0, 5.0);
    office.paint(1, 1.0, 1.0, 10.0, 4.0);
    EXPECT_EQ(office.kind(2), RoomKind::room);
    Regions beam(14.0, 3.0);
    beam.paint(1, 1.0, 1.0, 12.0, 1.6);
    EXPECT_EQ(beam.kind(1), RoomKind::room) << "a splinter that leads nowhere";
}

}  // namespace
}  // namespace quadcut
