// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_list.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <vector>

#include "io/number_text.hpp"
#include "io/room_text.hpp"
#include "io/utf8.hpp"

namespace quadcut::io {
namespace {

/// id, name, kind, area, doors
constexpr std::size_t kNumColumns = 5;
constexpr std::array<bool, kNumColumns> kIsNumber{true, false, false, true, true};
using TableRow = std::array<std::string, kNumColumns>;

std::map<RoomId, std::size_t> count_doors(const Segmentation& segmentation) {
    std::map<RoomId, std::size_t> counts;
    for (const Door& door : segmentation.doors) {
        ++counts[door.a];
        ++counts[door.b];
    }
    return counts;
}

/// Places in the list of rooms.
std::vector<std::size_t> largest_first(const std::vector<Room>& rooms) {
    std::vector<std::size_t> order(rooms.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&rooms](std::size_t a, std::size_t b) {
        return rooms[a].area_m2 > rooms[b].area_m2;
    });
    return order;
}

/// Columns that a text takes, each character taken as one wide.
std::size_t width_of(const std::string& text) { return decode_utf8(text).size(); }

std::string shortened(const std::string& name, const TableLimits& limits) {
    const std::u32string text = decode_utf8(name);
    if (text.size() <= limits.name_length) return name;
    std::string shorter;
    for (const char32_t c : text.substr(0, limits.name_length - 3)) append_utf8(shorter, c);
    return shorter + "...";
}

void append_row(std::string& table, const TableRow& row,
                const std::array<std::size_t, kNumColumns>& widths) {
    for (std::size_t i = 0; i < kNumColumns; ++i) {
        const std::string blanks(widths[i] - width_of(row[i]), ' ');
        table += i == 0 ? "" : "  ";
        table += kIsNumber[i] ? blanks + row[i] : row[i] + (i + 1 < kNumColumns ? blanks : "");
    }
    table += '\n';
}

}  // namespace

std::string room_table(const Segmentation& segmentation, const TableLimits& limits) {
    const std::vector<Room>& rooms = segmentation.rooms;
    if (rooms.empty()) return {};
    std::map<RoomId, std::size_t> num_doors = count_doors(segmentation);
    std::vector<TableRow> rows{{"id", "name", "kind", "area", "doors"}};
    for (const std::size_t place : largest_first(rooms)) {
        if (rows.size() > limits.rows) break;
        const Room& room = rooms[place];
        rows.push_back({std::to_string(index(room.id)), shortened(name_of(room), limits),
                        room.seen == Seen::glimpse ? "" : std::string(to_text(room.kind)),
                        with_decimals(room.area_m2, 1) + " m²",
                        std::to_string(num_doors[room.id])});
    }
    std::array<std::size_t, kNumColumns> widths{};
    for (const TableRow& row : rows) {
        for (std::size_t i = 0; i < kNumColumns; ++i) {
            widths[i] = std::max(widths[i], width_of(row[i]));
        }
    }
    std::string table;
    for (const TableRow& row : rows) append_row(table, row, widths);
    const std::size_t num_left = rooms.size() + 1 - rows.size();
    if (num_left > 0) {
        table += "and " + std::to_string(num_left) +
                 (num_left == 1 ? " smaller room\n" : " smaller rooms\n");
    }
    return table;
}

RoomTotals totals_of(const Segmentation& segmentation) {
    RoomTotals totals;
    for (const Room& room : segmentation.rooms) {
        if (room.seen == Seen::glimpse) {
            ++totals.num_glimpses;
        } else {
            ++totals.num_rooms;
            totals.area_m2 += room.area_m2;
        }
    }
    return totals;
}

void write_rooms_and_doors(JsonWriter& json, const Segmentation& segmentation) {
    std::map<RoomId, std::size_t> num_doors = count_doors(segmentation);
    const RoomTotals totals = totals_of(segmentation);
    json.key("num_rooms").integer(totals.num_rooms);
    json.key("num_glimpses").integer(totals.num_glimpses);
    json.key("num_doors").integer(segmentation.doors.size());
    json.key("area_m2").number(totals.area_m2);
    json.key("rooms").begin_array(JsonLayout::lines);
    for (const Room& room : segmentation.rooms) {
        json.begin_object().key("id").integer(index(room.id));
        json.key("name").text(name_of(room));
        json.key("kind").text(to_text(room.kind));
        json.key("area_m2").number(room.area_m2);
        json.key("seen").text(to_text(room.seen));
        json.key("num_doors").integer(num_doors[room.id]);
        json.key("x").number(room.label_point.x);
        json.key("y").number(room.label_point.y).end_object();
    }
    json.end_array().key("doors").begin_array(JsonLayout::lines);
    for (std::size_t i = 0; i < segmentation.doors.size(); ++i) {
        const Door& door = segmentation.doors[i];
        json.begin_object().key("id").integer(i + 1);
        json.key("a").integer(index(door.a));
        json.key("b").integer(index(door.b));
        json.key("width_m").number(door.width_m);
        json.key("x").number((door.jamb_1.x + door.jamb_2.x) / 2.0);
        json.key("y").number((door.jamb_1.y + door.jamb_2.y) / 2.0);
        json.end_object();
    }
    json.end_array();
}

}  // namespace quadcut::io
