// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/building.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/map/clearance.hpp"

namespace quadcut::sim {
namespace {

BuildingOptions options(std::uint64_t seed, int num_rooms = 14, double furniture = 1.0) {
    BuildingOptions result;
    result.seed = seed;
    result.num_rooms = num_rooms;
    result.furniture = furniture;
    return result;
}

template <typename T>
std::uint64_t hash(const Raster<T>& raster, std::uint64_t seed) {
    return io::hash_bytes(
        {reinterpret_cast<const char*>(raster.values.data()), raster.values.size() * sizeof(T)},
        seed);
}

std::uint64_t hash(const Building& building) {
    std::uint64_t h = hash(building.map.states, 1);
    h = hash(building.bare.states, h);
    h = hash(building.labels, h);
    h = hash(building.bare_labels, h);
    for (const TrueRoom& room : building.rooms) h = io::hash_bytes(room.name, h);
    for (const TrueDoor& door : building.doors) {
        const double numbers[] = {door.jamb_1.x, door.jamb_1.y, door.jamb_2.x, door.jamb_2.y};
        h = io::hash_bytes({reinterpret_cast<const char*>(numbers), sizeof(numbers)}, h);
    }
    return h;
}

// All cells that `passes` and that are 4-connected to `start`.
template <typename Passes>
std::vector<std::uint8_t> flood(const Raster<std::uint16_t>& raster, std::size_t start,
                                const Passes& passes) {
    std::vector<std::uint8_t> reached(raster.values.size(), 0);
    std::vector<std::size_t> queue{start};
    reached[start] = 1;
    while (!queue.empty()) {
        const Cell c = raster.cell(queue.back());
        queue.pop_back();
        for (const Cell& n :
             {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}}) {
            if (!raster.contains(n)) continue;
            const std::size_t i = raster.offset(n);
            if (reached[i] != 0 || !passes(i)) continue;
            reached[i] = 1;
            queue.push_back(i);
        }
    }
    return reached;
}

Cell cell_of(const GridMap& map, const Point& p) {
    return {static_cast<std::int32_t>(std::floor((p.x - map.map_from_image.x) / map.resolution_m)),
            static_cast<std::int32_t>(std::floor((p.y - map.map_from_image.y) / map.resolution_m))};
}

// How far one can go from `from` in a direction before leaving the free cells.
double free_way(const GridMap& map, const Point& from, const Point& direction) {
    const double step = 0.02 * map.resolution_m;
    double way = 0.0;
    while (map.states.at(cell_of(map, {from.x + way * direction.x, from.y + way * direction.y})) ==
           CellState::free) {
        way += step;
    }
    return way;
}

TEST(Building, SameSeedSameBytesOtherSeedOtherBuilding) {
    std::set<std::uint64_t> hashes;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const std::uint64_t first = hash(generate_building(options(seed)));
        EXPECT_EQ(first, hash(generate_building(options(seed))));
        hashes.insert(first);
    }
    EXPECT_EQ(hashes.size(), 8U);
}

TEST(Building, RefusesOptionsOutOfRange) {
    const auto refused = [](auto change) {
        BuildingOptions bad;
        change(bad);
        EXPECT_THROW((void)generate_building(bad), InputError);
    };
    refused([](BuildingOptions& o) { o.num_rooms = 2; });
    refused([](BuildingOptions& o) { o.num_rooms = 1001; });
    refused([](BuildingOptions& o) { o.furniture = 1.5; });
    refused([](BuildingOptions& o) { o.furniture = std::nan(""); });
    refused([](BuildingOptions& o) { o.resolution_m = 0.0; });
    refused([](BuildingOptions& o) { o.turned_wings = -0.1; });
    refused([](BuildingOptions& o) { o.yaw_rad = std::numeric_limits<double>::infinity(); });
    refused([](BuildingOptions& o) { o.open_leaves = 2.0; });
}

TEST(Building, HasAboutAsManyRoomsAsWished) {
    for (const int wish : {3, 4, 6, 10, 20, 60, 300}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Building building = generate_building(options(seed, wish, 0.0));
            const auto rooms = static_cast<int>(building.rooms.size());
            EXPECT_NEAR(rooms, wish, 1.0 + 0.125 * wish) << seed;
            EXPECT_GE(building.doors.size(), building.rooms.size() - 1);
            for (std::size_t i = 0; i < building.rooms.size(); ++i) {
                const TrueRoom& room = building.rooms[i];
                EXPECT_EQ(static_cast<std::size_t>(room.id), i + 1);
                EXPECT_GT(room.area_m2, 1.4) << room.name;
                EXPECT_EQ(room.kind == RoomKind::hall, room.name.starts_with("Hall"));
                if (room.kind == RoomKind::hall) {
                    EXPECT_GT(room.area_m2, 75.0);
                }
            }
        }
    }
}

TEST(Building, LabelsAreExactlyTheFreeCellsThatCanBeReached) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Building b = generate_building(options(seed, 24));
        for (const auto& [map, labels] :
             {std::pair{&b.map, &b.labels}, std::pair{&b.bare, &b.bare_labels}}) {
            for (std::size_t i = 0; i < labels->values.size(); ++i) {
                if (labels->values[i] == 0) continue;
                ASSERT_EQ(map->states.values[i], CellState::free);
                ASSERT_LE(labels->values[i], b.rooms.size());
            }
        }
        const Raster<std::uint16_t>& labels = b.bare_labels;
        const auto start = static_cast<std::size_t>(
            std::find(labels.values.begin(), labels.values.end(), 1) - labels.values.begin());
        const std::vector<std::uint8_t> reached = flood(labels, start, [&](std::size_t i) {
            return b.bare.states.values[i] == CellState::free;
        });
        for (std::size_t i = 0; i < reached.size(); ++i) {
            ASSERT_EQ(reached[i] != 0, labels.values[i] != 0) << "seed " << seed << " cell " << i;
        }
    }
}

TEST(Building, EachRoomIsConnected) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Building b = generate_building(options(seed, 40, 0.0));
        for (const TrueRoom& room : b.rooms) {
            const auto label = static_cast<std::uint16_t>(room.id);
            const auto& values = b.bare_labels.values;
            const auto first = std::find(values.begin(), values.end(), label);
            ASSERT_NE(first, values.end()) << room.name;
            const std::vector<std::uint8_t> reached =
                flood(b.bare_labels, static_cast<std::size_t>(first - values.begin()),
                      [&](std::size_t i) { return values[i] == label; });
            EXPECT_EQ(std::count(reached.begin(), reached.end(), 1),
                      std::count(values.begin(), values.end(), label))
                << room.name;
        }
    }
}

TEST(Building, DoorsAreAsWideAsTheySayAndTheirLineIsTheBorder) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Building b = generate_building(options(seed, 30, 0.0));
        for (const TrueDoor& door : b.doors) {
            EXPECT_NEAR(distance(door.jamb_1, door.jamb_2), door.width_m, 1e-9);
            const Point along{(door.jamb_2.x - door.jamb_1.x) / door.width_m,
                              (door.jamb_2.y - door.jamb_1.y) / door.width_m};
            const Point middle{0.5 * (door.jamb_1.x + door.jamb_2.x),
                               0.5 * (door.jamb_1.y + door.jamb_2.y)};
            const double measured =
                free_way(b.bare, middle, along) + free_way(b.bare, middle, {-along.x, -along.y});
            EXPECT_NEAR(measured, door.width_m, 1.5 * b.bare.resolution_m)
                << "seed " << seed << " at " << middle.x << ", " << middle.y;
            std::set<std::uint16_t> sides;
            for (const double side : {-0.08, 0.08}) {
                sides.insert(b.bare_labels.at(
                    cell_of(b.bare, {middle.x - side * along.y, middle.y + side * along.x})));
            }
            EXPECT_EQ(sides, (std::set<std::uint16_t>{static_cast<std::uint16_t>(door.a),
                                                      static_cast<std::uint16_t>(door.b)}));
        }
    }
}

TEST(Building, ARobotGetsIntoEveryRoomAndAlmostEverywhereInIt) {
    constexpr float kRadius = 0.22F;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const Building b = generate_building(options(seed, 22, 1.0));
        const auto fits = [&](const GridMap& map) {
            Raster<std::uint8_t> open({0, 0}, map.states.width, map.states.height);
            for (std::size_t i = 0; i < open.values.size(); ++i) {
                open.values[i] = map.states.values[i] == CellState::free ? 1 : 0;
            }
            const Raster<float> clearance = clearance_m(open, map.resolution_m);
            std::vector<std::uint8_t> result(open.values.size());
            for (std::size_t i = 0; i < result.size(); ++i) {
                result[i] = clearance.values[i] >= kRadius ? 1 : 0;
            }
            return result;
        };
        const std::vector<std::uint8_t> furnished = fits(b.map);
        const std::vector<std::uint8_t> bare = fits(b.bare);
        std::size_t start = 0;
        while (furnished[start] == 0 || b.labels.values[start] != 1) ++start;
        const std::vector<std::uint8_t> reached =
            flood(b.labels, start, [&](std::size_t i) { return furnished[i] != 0; });
        std::vector<double> num_reached(b.rooms.size() + 1, 0.0);
        std::vector<double> num_free(b.rooms.size() + 1, 0.0);
        std::vector<double> num_bare(b.rooms.size() + 1, 0.0);
        for (std::size_t i = 0; i < reached.size(); ++i) {
            num_reached[b.labels.values[i]] += reached[i];
            num_free[b.labels.values[i]] += furnished[i];
            num_bare[b.bare_labels.values[i]] += bare[i];
        }
        for (const TrueRoom& room : b.rooms) {
            const auto id = static_cast<std::size_t>(room.id);
            EXPECT_GT(num_reached[id], 0.05 * num_bare[id]) << "seed " << seed << " " << room.name;
            // Pockets between and under pieces aside.
            constexpr double kPockets = 0.6 / (0.05 * 0.05);
            EXPECT_GT(num_reached[id], std::min(0.75 * num_free[id], num_free[id] - kPockets))
                << "seed " << seed << " " << room.name;
        }
    }
}

TEST(Building, DenserFurnitureOnlyAdds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        BuildingOptions wish = options(seed, 20, 0.0);
        wish.open_leaves = 0.0;
        Building before = generate_building(wish);
        EXPECT_EQ(before.map.states.values, before.bare.states.values);
        EXPECT_EQ(before.labels.values, before.bare_labels.values);
        for (const double density : {0.25, 0.5, 0.75, 1.0}) {
            wish.furniture = density;
            Building after = generate_building(wish);
            EXPECT_EQ(before.bare.states.values, after.bare.states.values);
            const auto num_free = [](const Building& b) {
                return std::count(b.map.states.values.begin(), b.map.states.values.end(),
                                  CellState::free);
            };
            EXPECT_LT(num_free(after), num_free(before)) << density;
            for (std::size_t i = 0; i < after.map.states.values.size(); ++i) {
                ASSERT_FALSE(after.map.states.values[i] == CellState::free &&
                             before.map.states.values[i] != CellState::free);
            }
            before = std::move(after);
        }
    }
}

TEST(Building, WingsAreTurnedAsWished) {
    const auto off_axis = [](const Building& b) {
        return std::count_if(b.doors.begin(), b.doors.end(), [](const TrueDoor& door) {
            const double angle =
                std::atan2(door.jamb_2.y - door.jamb_1.y, door.jamb_2.x - door.jamb_1.x);
            return std::abs(std::remainder(angle, M_PI / 2.0)) > 0.1;
        });
    };
    BuildingOptions wish = options(3, 50, 0.0);
    wish.turned_wings = 0.0;
    const Building straight = generate_building(wish);
    EXPECT_EQ(straight.num_turned_wings, 0);
    EXPECT_EQ(off_axis(straight), 0);
    wish.turned_wings = 1.0;
    const Building turned = generate_building(wish);
    EXPECT_GT(turned.num_turned_wings, 0);
    EXPECT_GT(off_axis(turned), 5);
    wish.turned_wings = 0.0;
    wish.yaw_rad = 0.4;
    const Building whole = generate_building(wish);
    EXPECT_EQ(whole.num_turned_wings, 0);
    EXPECT_EQ(off_axis(whole), static_cast<std::ptrdiff_t>(whole.doors.size()));
}

TEST(Building, ACampusHasItsWingsJoinedByDoors) {
    BuildingOptions wish;
    wish.seed = 12;
    wish.num_rooms = 60;
    wish.num_wings = 4;
    const Building campus = generate_building(wish);
    std::map<int, int> rooms_of_wing;
    for (const TrueRoom& room : campus.rooms) ++rooms_of_wing[room.wing];
    ASSERT_EQ(rooms_of_wing.size(), 4U);
    for (const auto& [wing, count] : rooms_of_wing) EXPECT_GE(count, 5) << wing;
    std::set<std::pair<int, int>> joined;
    for (const TrueDoor& door : campus.doors) {
        const int a = campus.rooms[index(door.a) - 1].wing;
        const int b = campus.rooms[index(door.b) - 1].wing;
        if (a == b) continue;
        EXPECT_LE(door.width_m, 1.2);
        joined.insert({std::min(a, b), std::max(a, b)});
    }
    // A tree: as many joints as wings, less one.
    EXPECT_EQ(joined.size(), 3U);
}

TEST(Building, OtherResolutionIsTheSameBuilding) {
    BuildingOptions wish = options(5, 14, 0.5);
    const Building fine = generate_building(wish);
    wish.resolution_m = 0.1;
    const Building coarse = generate_building(wish);
    ASSERT_EQ(fine.rooms.size(), coarse.rooms.size());
    for (std::size_t i = 0; i < fine.rooms.size(); ++i) {
        EXPECT_EQ(fine.rooms[i].name, coarse.rooms[i].name);
        EXPECT_NEAR(fine.rooms[i].area_m2, coarse.rooms[i].area_m2,
                    0.1 * fine.rooms[i].area_m2 + 0.3);
    }
}

// What the buildings must have between them to be worth measuring on.
TEST(Building, AllThatMakesMapsHardOccurs) {
    int open_passages = 0;
    int double_doors = 0;
    int small_rooms = 0;
    int l_shapes = 0;
    int inner_rooms = 0;
    int halls = 0;
    int false_free_maps = 0;
    int rings = 0;
    std::set<std::string> uses;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Building b = generate_building(options(seed, 10 + 2 * static_cast<int>(seed), 0.0));
        std::vector<std::uint8_t> has_corridor_door(b.rooms.size() + 1, 0);
        for (const TrueDoor& door : b.doors) {
            EXPECT_GE(door.width_m, 0.69);
            EXPECT_LE(door.width_m, door.is_open_passage ? 2.7 : 1.71);
            open_passages += door.is_open_passage ? 1 : 0;
            double_doors += !door.is_open_passage && door.width_m > 1.25 ? 1 : 0;
            const auto kind = [&](RoomId id) { return b.rooms[index(id) - 1].kind; };
            if (kind(door.a) == RoomKind::corridor) has_corridor_door[index(door.b)] = 1;
            if (kind(door.b) == RoomKind::corridor) has_corridor_door[index(door.a)] = 1;
        }
        for (const TrueRoom& room : b.rooms) {
            uses.insert(room.name.substr(0, room.name.find_last_of(' ')));
            small_rooms += room.area_m2 >= 2.0 && room.area_m2 <= 5.0 ? 1 : 0;
            halls += room.kind == RoomKind::hall ? 1 : 0;
            if (room.kind != RoomKind::corridor) {
                l_shapes += room.floor.size() > 1 ? 1 : 0;
                inner_rooms += has_corridor_door[index(room.id)] == 0 ? 1 : 0;
            }
        }
        bool has_false_free = false;
        for (std::size_t i = 0; i < b.bare_labels.values.size(); ++i) {
            has_false_free |=
                b.bare_labels.values[i] == 0 && b.bare.states.values[i] == CellState::free;
        }
        false_free_maps += has_false_free ? 1 : 0;
        rings += b.doors.size() >= b.rooms.size() ? 1 : 0;
    }
    EXPECT_GT(open_passages, 40);
    EXPECT_GT(double_doors, 20);
    EXPECT_GT(small_rooms, 40);
    EXPECT_GT(l_shapes, 40);
    EXPECT_GT(inner_rooms, 40);
    EXPECT_GT(halls, 10);
    EXPECT_GT(false_free_maps, 8);
    EXPECT_GT(rings, 8);
    EXPECT_GE(uses.size(), 15U);
}

}  // namespace
}  // namespace quadcut::sim
