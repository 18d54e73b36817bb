// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "io/file.hpp"
#include "project/seen_rows.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/check_followed.hpp"
#include "quadcut/follow/live_doors.hpp"

namespace quadcut::project {
namespace {

constexpr std::int64_t kMaxCount = std::int64_t{1} << 53;

/// A tile whose x is in the given column and whose y is in the next.
Cell tile_at(const Statement& row, int column) {
    constexpr std::int64_t kMaxTile = kMaxCoordinate / kTileSide;
    return {static_cast<std::int32_t>(row.integer(column, -kMaxTile, kMaxTile)),
            static_cast<std::int32_t>(row.integer(column + 1, -kMaxTile, kMaxTile))};
}

std::int64_t signed_count(std::size_t count) { return static_cast<std::int64_t>(count); }

/// One byte, or 64, when not all are the same.
std::string bytes_of(const Tile& tile) {
    std::string bytes;
    for (const std::int8_t value : tile.values) bytes += static_cast<char>(value);
    const bool is_uniform =
        std::all_of(bytes.begin(), bytes.end(), [&](char byte) { return byte == bytes.front(); });
    return is_uniform ? bytes.substr(0, 1) : bytes;
}

/// Four bytes a cell, the lowest first; one cell, or 64, when not all are the same.
std::string bytes_of(const std::array<std::uint32_t, kTileCells>& rooms) {
    const bool is_uniform = std::all_of(rooms.begin(), rooms.end(),
                                        [&](std::uint32_t room) { return room == rooms.front(); });
    std::string bytes;
    for (std::size_t i = 0; i < (is_uniform ? 1 : kTileCells); ++i) {
        for (int shift = 0; shift < 32; shift += 8) {
            bytes += static_cast<char>(rooms[i] >> shift & 0xffU);
        }
    }
    return bytes;
}

[[noreturn]] void refuse_size(const Database& database, const std::string& column,
                              std::size_t size) {
    throw InputError(io::display_name(database.path()) + ": table tiles, " + column + " of " +
                     std::to_string(size) + " bytes: expected those of one cell or of 64");
}

void read_log_odds(const Database& database, const std::string& bytes, Tile& tile) {
    if (bytes.size() != 1 && bytes.size() != kTileCells) {
        refuse_size(database, "log_odds", bytes.size());
    }
    for (std::size_t i = 0; i < kTileCells; ++i) {
        tile.values[i] = static_cast<std::int8_t>(bytes[bytes.size() == 1 ? 0 : i]);
    }
}

void read_rooms(const Database& database, const std::string& bytes, RoomTile& tile) {
    if (bytes.size() != 4 && bytes.size() != 4 * kTileCells) {
        refuse_size(database, "rooms", bytes.size());
    }
    for (std::size_t i = 0; i < kTileCells; ++i) {
        const std::size_t from = bytes.size() == 4 ? 0 : 4 * i;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto byte = static_cast<unsigned char>(bytes[from + k]);
            tile.rooms[i] |= std::uint32_t{byte} << (8 * k);
        }
    }
}

void write_tiles(const Database& database, const FollowedMap& state, std::span<const Cell> tiles) {
    Statement insert(database, "INSERT OR REPLACE INTO tiles VALUES(?, ?, ?, ?, ?)");
    for (const Cell tile : tiles) {
        const RoomTile& cells = state.cells.tile(tile);
        const std::string log_odds = bytes_of(state.map.tile(tile));
        const std::string rooms = bytes_of(cells.rooms);
        bind_cell(insert, 1, tile);
        insert.bind_bytes(3, log_odds)
            .bind_bytes(4, rooms)
            .bind(5, static_cast<std::int64_t>(cells.cut_free))
            .run();
    }
}

void write_rooms(const Database& database, const FollowedMap& state) {
    Statement(database, "DELETE FROM rooms").run();
    Statement insert(database, "INSERT INTO rooms VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const auto& [id, room] : state.rooms) {
        insert.bind(1, std::int64_t{id})
            .bind(2, std::string_view(room.name))
            .bind(3, std::int64_t{room.merge_group})
            .bind(4, std::int64_t{room.is_locked})
            .bind(5, static_cast<double>(room.num_cells) * state.cell_m2())
            .bind(6, room.peak_m);
        bind_cell(insert, 7, room.box.low);
        bind_cell(insert, 9, room.box.high);
        insert.bind(11, room.announced_m2)
            .bind(12, signed_count(room.decided_cells))
            .bind(13, signed_count(room.next_block))
            .run();
    }
}

void write_doors(const Database& database, const FollowedMap& state) {
    Statement(database, "DELETE FROM doors").run();
    Statement insert(database,
                     "INSERT INTO doors(room_a, room_b, ax, ay, bx, by, clearance_m) "
                     "VALUES(?, ?, ?, ?, ?, ?, ?)");
    for (const RoomOpening& opening : state.openings) {
        insert.bind(1, std::int64_t{state.cells.room(opening.a)})
            .bind(2, std::int64_t{state.cells.room(opening.b)});
        bind_cell(insert, 3, opening.a);
        bind_cell(insert, 5, opening.b);
        insert.bind(7, static_cast<double>(opening.clearance_m)).run();
    }
}

void write_door_lines(const Database& database, const FollowedMap& state) {
    Statement(database, "DELETE FROM door_lines").run();
    Statement insert(database,
                     "INSERT INTO door_lines VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const auto& [id, placed] : state.doors) {
        const Door& door = placed.door;
        insert.bind(1, std::int64_t{static_cast<std::uint32_t>(id)});
        bind_cell(insert, 2, placed.a);
        bind_cell(insert, 4, placed.b);
        insert.bind(6, door.jamb_1.x)
            .bind(7, door.jamb_1.y)
            .bind(8, door.jamb_2.x)
            .bind(9, door.jamb_2.y)
            .bind(10, door.width_m)
            .bind(11, door.room_a_width_m)
            .bind(12, door.room_b_width_m)
            .bind(13, door.confidence)
            .run();
    }
}

void write_rest(const Database& database, const FollowedMap& state) {
    Statement(database, "DELETE FROM changes").run();
    Statement change(database, "INSERT INTO changes VALUES(?, ?, ?)");
    for (const auto& [tile, count] : state.changed_tiles) {
        bind_cell(change, 1, {tile.first, tile.second});
        change.bind(3, signed_count(count)).run();
    }
    Statement(database, "DELETE FROM seen").run();
    Statement seen(database, "INSERT INTO seen VALUES(?)");
    for (const std::uint32_t room : state.seen) seen.bind(1, std::int64_t{room}).run();
    Statement(database, "DELETE FROM split_lines").run();
    Statement split(database,
                    "INSERT INTO split_lines(from_x, from_y, to_x, to_y) VALUES(?, ?, ?, ?)");
    for (const SplitLine& line : state.split_lines) {
        bind_cell(split, 1, line.from);
        bind_cell(split, 3, line.to);
        split.run();
    }
    Statement meta(database, "INSERT OR REPLACE INTO meta VALUES(?, ?)");
    const auto write = [&](std::string_view key, std::int64_t value) {
        meta.bind(1, key).bind(2, value).run();
    };
    const bool is_placed = state.map.is_placed();
    const Root& root = state.map.root();
    write("root_level", is_placed ? root.level : 0);
    write("root_x", is_placed ? root.lower_left.x : 0);
    write("root_y", is_placed ? root.lower_left.y : 0);
    write("low_x", state.written.low.x);
    write("low_y", state.written.low.y);
    write("high_x", state.written.high.x);
    write("high_y", state.written.high.y);
    write("num_scans", signed_count(state.num_scans));
    write("next_id", state.next_id);
    write("num_left_over", signed_count(state.num_left_over));
    write("cut_at", signed_count(state.cut_at));
    write("roomless_low_x", state.seen_roomless.low.x);
    write("roomless_low_y", state.seen_roomless.low.y);
    write("roomless_high_x", state.seen_roomless.high.x);
    write("roomless_high_y", state.seen_roomless.high.y);
    write("next_door_id", state.next_door_id);
    write("revision", static_cast<std::int64_t>(state.revision));
}

/// What projects before version 3 or 4 do not have.
std::int64_t read_number_or(const Database& database, std::string_view key,
                            std::int64_t otherwise) {
    Statement row(database, "SELECT value FROM meta WHERE key = ?");
    row.bind(1, key);
    return row.step() ? row.integer(0, -4 * kMaxCoordinate, kMaxCount) : otherwise;
}

std::map<std::string, std::int64_t> read_numbers(const Database& database) {
    std::map<std::string, std::int64_t> numbers;
    for (const char* key : {"root_level", "root_x", "root_y", "low_x", "low_y", "high_x", "high_y",
                            "num_scans", "next_id", "num_left_over", "cut_at"}) {
        Statement row(database, "SELECT value FROM meta WHERE key = ?");
        row.bind(1, std::string_view(key));
        if (!row.step()) {
            throw InputError(io::display_name(database.path()) +
                             ": is incomplete: expected a row '" + key + "' in its table meta");
        }
        numbers[key] = row.integer(0, -4 * kMaxCoordinate, kMaxCount);
    }
    numbers["next_door_id"] = read_number_or(database, "next_door_id", 1);
    numbers["revision"] = read_number_or(database, "revision", 0);
    for (const char* key : {"roomless_low_x", "roomless_low_y"}) {
        numbers[key] = read_number_or(database, key, 0);
    }
    for (const char* key : {"roomless_high_x", "roomless_high_y"}) {
        numbers[key] = read_number_or(database, key, -1);
    }
    return numbers;
}

/// Numbers, and where the map's tree stands.
FollowedMap read_meta(const Database& database, double resolution_m) {
    const std::map<std::string, std::int64_t> numbers = read_numbers(database);
    const auto number = [&](const char* key, std::int64_t low, std::int64_t high) {
        const std::int64_t value = numbers.at(key);
        if (value < low || value > high) {
            throw InputError(io::display_name(database.path()) + ": table meta, " + key + ": " +
                             std::to_string(value) + " cannot be");
        }
        return value;
    };
    const auto coordinate = [&](const char* key, std::int64_t limit) {
        return static_cast<std::int32_t>(number(key, -limit, limit));
    };
    const auto count = [&](const char* key) {
        return static_cast<std::size_t>(number(key, 0, kMaxCount));
    };
    FollowedMap state(resolution_m);
    const auto level = static_cast<std::uint8_t>(number("root_level", 0, 30));
    if (level > 0) {
        const Cell low{coordinate("root_x", 4 * kMaxCoordinate),
                       coordinate("root_y", 4 * kMaxCoordinate)};
        state.map = OccupancyMap(resolution_m, {}, Root{low, level});
    }
    state.written = {{coordinate("low_x", kMaxCoordinate), coordinate("low_y", kMaxCoordinate)},
                     {coordinate("high_x", kMaxCoordinate), coordinate("high_y", kMaxCoordinate)}};
    state.seen_roomless = {{coordinate("roomless_low_x", kMaxCoordinate),
                            coordinate("roomless_low_y", kMaxCoordinate)},
                           {coordinate("roomless_high_x", kMaxCoordinate),
                            coordinate("roomless_high_y", kMaxCoordinate)}};
    state.num_scans = count("num_scans");
    state.next_id = static_cast<std::uint32_t>(number("next_id", 1, kMaxRoom));
    state.num_left_over = count("num_left_over");
    state.cut_at = count("cut_at");
    state.next_door_id = static_cast<std::uint32_t>(number("next_door_id", 1, kMaxRoom));
    state.revision = static_cast<std::uint64_t>(number("revision", 0, kMaxCount));
    return state;
}

void read_rooms_table(const Database& database, FollowedMap& state) {
    Statement row(database,
                  "SELECT id, name, merge_group, locked, peak_m, low_x, low_y, high_x, high_y, "
                  "announced_m2, decided_cells, next_block, area_m2 FROM rooms ORDER BY id");
    while (row.step()) {
        FollowedRoom room;
        room.name = row.text(1);
        room.merge_group = static_cast<std::uint32_t>(row.integer(2, 0, kMaxRoom));
        room.is_locked = row.integer(3, 0, 1) != 0;
        room.peak_m = row.number(4);
        room.box = {cell_at(row, 5), cell_at(row, 7)};
        room.announced_m2 = row.number(9);
        room.decided_cells = static_cast<std::size_t>(row.integer(10, 0, kMaxCount));
        room.next_block = static_cast<std::size_t>(row.integer(11, 0, kMaxCount));
        const double num_cells = std::round(row.number(12) / state.cell_m2());
        room.num_cells = static_cast<std::size_t>(std::clamp(num_cells, 0.0, 1e15));
        state.rooms[static_cast<std::uint32_t>(row.integer(0, 1, kMaxRoom))] = room;
    }
}

void read_door_lines(const Database& database, FollowedMap& state) {
    Statement row(database,
                  "SELECT id, ax, ay, bx, by, x1, y1, x2, y2, width_m, room_a_width_m, "
                  "room_b_width_m, confidence FROM door_lines ORDER BY id");
    while (row.step()) {
        PlacedDoor placed{{}, cell_at(row, 1), cell_at(row, 3)};
        placed.door.a = RoomId{state.cells.room(placed.a)};
        placed.door.b = RoomId{state.cells.room(placed.b)};
        placed.door.jamb_1 = {row.number(5), row.number(6)};
        placed.door.jamb_2 = {row.number(7), row.number(8)};
        placed.door.width_m = row.number(9);
        placed.door.room_a_width_m = row.number(10);
        placed.door.room_b_width_m = row.number(11);
        placed.door.confidence = row.number(12);
        state.doors[DoorId{static_cast<std::uint32_t>(row.integer(0, 1, kMaxRoom))}] = placed;
    }
}

void read_lists(const Database& database, FollowedMap& state) {
    Statement door(database, "SELECT ax, ay, bx, by, clearance_m FROM doors ORDER BY seq");
    while (door.step()) {
        state.openings.push_back({cell_at(door, 0), cell_at(door, 2),
                                  static_cast<float>(std::clamp(door.number(4), 0.0, 1e6))});
    }
    Statement change(database, "SELECT x, y, cells FROM changes ORDER BY x, y");
    while (change.step()) {
        const Cell tile = tile_at(change, 0);
        const auto count = static_cast<std::size_t>(change.integer(2, 1, std::int64_t{kTileCells}));
        state.num_changed += count;
        if (state.changed_tiles.emplace(std::pair{tile.x, tile.y}, count).second) continue;
        throw InputError(io::display_name(database.path()) + ": table changes: tile (" +
                         std::to_string(tile.x) + ", " + std::to_string(tile.y) +
                         ") is there twice");
    }
    Statement seen(database, "SELECT room FROM seen");
    while (seen.step()) {
        state.seen.insert(static_cast<std::uint32_t>(seen.integer(0, 1, kMaxRoom)));
    }
    Statement split(database, "SELECT from_x, from_y, to_x, to_y FROM split_lines ORDER BY seq");
    while (split.step()) state.split_lines.push_back({cell_at(split, 0), cell_at(split, 2)});
}

}  // namespace

void bind_cell(Statement& statement, int place, Cell cell) {
    statement.bind(place, std::int64_t{cell.x}).bind(place + 1, std::int64_t{cell.y});
}

Cell cell_at(const Statement& row, int column) {
    return {static_cast<std::int32_t>(row.integer(column, -kMaxCoordinate, kMaxCoordinate)),
            static_cast<std::int32_t>(row.integer(column + 1, -kMaxCoordinate, kMaxCoordinate))};
}

bool has_table(const Database& database, std::string_view name) {
    return Statement(database, "SELECT 1 FROM sqlite_master WHERE name = ?").bind(1, name).step();
}

void write_state(const Database& database, const FollowedMap& state, std::span<const Cell> tiles) {
    write_tiles(database, state, tiles);
    write_rooms(database, state);
    write_doors(database, state);
    write_door_lines(database, state);
    write_covisibility(database, state);
    write_rest(database, state);
}

FollowedMap read_state(const Database& database, const FollowOptions& options) {
    FollowedMap state = read_meta(database, options.resolution_m);
    require_room_for(state, {});
    read_rooms_table(database, state);
    read_lists(database, state);
    read_way(database, state);
    read_covisibility(database, state);
    const bool is_placed = state.map.is_placed();
    const Root root = state.map.root();
    Statement row(database, "SELECT x, y, log_odds, rooms, cut_free FROM tiles ORDER BY y, x");
    while (row.step()) {
        Tile log_odds;
        RoomTile rooms;
        read_log_odds(database, row.bytes(2), log_odds);
        read_rooms(database, row.bytes(3), rooms);
        rooms.cut_free = static_cast<std::uint64_t>(row.integer(
            4, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
        add_tile(state, tile_at(row, 0), log_odds, rooms);
    }
    state.map.commit();
    if (is_placed && state.map.root() != root) throw InputError("tiles lie outside of the map");
    // Who listens and knows of no revision has seen nothing of this.
    if (is_placed && state.revision == 0) state.revision = 1;
    if (read_number_or(database, "next_door_id", 0) != 0) {
        read_door_lines(database, state);
        return state;
    }
    // Before version 3 doors were not kept.
    check(state);
    Changes changes;
    update_doors(state, state.written, {}, options.segment.rooms, {}, changes);
    return state;
}

}  // namespace quadcut::project
