// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/edit_history.hpp"

#include <array>
#include <limits>
#include <string_view>
#include <utility>

#include "io/file.hpp"
#include "project/edit_text.hpp"
#include "project/project_rows.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::project {
namespace {

const std::array<std::string_view, 5> kKinds{name_of(EditKind::rename), name_of(EditKind::merge),
                                             name_of(EditKind::split), name_of(EditKind::lock),
                                             name_of(EditKind::unlock)};
constexpr std::array<std::string_view, 4> kStates{"done", "undone", "dropped", "fixed"};
constexpr std::array<std::string_view, 3> kBorders{"none", "part", "join"};

/// The place of a word.
template <std::size_t kSize>
std::size_t place_of(const std::array<std::string_view, kSize>& words, const std::string& word,
                     const Database& database) {
    for (std::size_t i = 0; i < kSize; ++i) {
        if (words[i] == word) return i;
    }
    throw InputError(io::display_name(database.path()) + ": an edit: '" + word + "' cannot be");
}

std::uint32_t room_at(const Statement& row, int column) {
    return static_cast<std::uint32_t>(row.integer(column, 0, kMaxRoom));
}

void forget_inverse(const Database& database, std::int64_t number) {
    for (const char* table : {"undo", "undo_cells", "undo_lines", "undo_rooms"}) {
        Statement(database, std::string("DELETE FROM ") + table + " WHERE edit = ?")
            .bind(1, number)
            .run();
    }
}

void write_state(const Database& database, std::int64_t number, EditState state,
                 Reversal::Border border) {
    Statement(database, "INSERT INTO undo VALUES(?, ?, ?)")
        .bind(1, number)
        .bind(2, kStates.at(static_cast<std::size_t>(state)))
        .bind(3, kBorders.at(static_cast<std::size_t>(border)))
        .run();
}

Reversal::Border read_border(const Database& database, std::int64_t number) {
    Statement row(database, "SELECT border FROM undo WHERE edit = ?");
    row.bind(1, number);
    if (!row.step()) return Reversal::Border::none;
    return static_cast<Reversal::Border>(place_of(kBorders, row.text(0), database));
}

}  // namespace

std::vector<EditRecord> read_edits(const Database& database, double resolution_m) {
    const bool has_undo = database.pragma("user_version") >= 2;
    const std::string state = has_undo ? "coalesce(undo.state, 'fixed')" : "'fixed'";
    const std::string join = has_undo ? " LEFT JOIN undo ON undo.edit = seq" : "";
    Statement row(database,
                  "SELECT kind, room, other, name, from_x, from_y, to_x, to_y, seq, scan, " +
                      state + " FROM edits" + join + " ORDER BY seq");
    const auto middle_of = [&](Cell cell) {
        return Point{(cell.x + 0.5) * resolution_m, (cell.y + 0.5) * resolution_m};
    };
    std::vector<EditRecord> edits;
    while (row.step()) {
        EditRecord record;
        record.edit = {static_cast<EditKind>(place_of(kKinds, row.text(0), database)),
                       RoomId{room_at(row, 1)},
                       RoomId{room_at(row, 2)},
                       row.text(3),
                       middle_of(cell_at(row, 4)),
                       middle_of(cell_at(row, 6))};
        record.number = row.integer(8, 1, std::numeric_limits<std::int64_t>::max());
        record.scan = static_cast<std::size_t>(row.integer(9, 0, std::int64_t{1} << 53));
        record.state = static_cast<EditState>(place_of(kStates, row.text(10), database));
        edits.push_back(std::move(record));
    }
    return edits;
}

std::int64_t write_edit(const Database& database, const EditRecord& record,
                        const Reversal& inverse) {
    Statement undone(database, "SELECT edit FROM undo WHERE state = 'undone'");
    std::vector<std::int64_t> dropped;
    while (undone.step()) {
        dropped.push_back(undone.integer(0, 1, std::numeric_limits<std::int64_t>::max()));
    }
    for (const std::int64_t number : dropped) {
        forget_inverse(database, number);
        write_state(database, number, EditState::dropped, Reversal::Border::none);
    }
    const Edit& edit = record.edit;
    Statement insert(database,
                     "INSERT INTO edits(scan, kind, room, other, name, from_x, from_y, to_x, to_y) "
                     "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, static_cast<std::int64_t>(record.scan))
        .bind(2, name_of(edit.kind))
        .bind(3, static_cast<std::int64_t>(index(edit.room)))
        .bind(4, static_cast<std::int64_t>(index(edit.other)))
        .bind(5, std::string_view(edit.name));
    const SplitLine line = edit.kind == EditKind::split ? inverse.lines.front() : SplitLine{};
    bind_cell(insert, 6, line.from);
    bind_cell(insert, 8, line.to);
    insert.run();
    Statement last(database, "SELECT last_insert_rowid()");
    last.step();
    const std::int64_t number = last.integer(0, 1, std::numeric_limits<std::int64_t>::max());
    write_inverse(database, number, EditState::done, inverse);
    return number;
}

Reversal read_inverse(const Database& database, const EditRecord& record) {
    Reversal reversal;
    reversal.room = record.edit.room;
    reversal.other = record.edit.other;
    reversal.border = read_border(database, record.number);
    Statement room(database,
                   "SELECT room, name, merge_group, locked FROM undo_rooms WHERE edit = ?");
    room.bind(1, record.number);
    while (room.step()) {
        reversal.settings[room_at(room, 0)] = {room.text(1), room_at(room, 2),
                                               room.integer(3, 0, 1) != 0};
    }
    Statement cells(database, "SELECT x, y, cells FROM undo_cells WHERE edit = ?");
    cells.bind(1, record.number);
    while (cells.step()) {
        const Cell tile = cell_at(cells, 0);
        reversal.cells[{tile.x, tile.y}] = static_cast<std::uint64_t>(cells.integer(
            2, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
    }
    Statement line(database, "SELECT from_x, from_y, to_x, to_y FROM undo_lines WHERE edit = ?");
    line.bind(1, record.number);
    while (line.step()) reversal.lines.push_back({cell_at(line, 0), cell_at(line, 2)});
    return reversal;
}

void write_inverse(const Database& database, std::int64_t number, EditState state,
                   const Reversal& inverse) {
    forget_inverse(database, number);
    write_state(database, number, state, inverse.border);
    Statement room(database, "INSERT INTO undo_rooms VALUES(?, ?, ?, ?, ?)");
    for (const auto& [id, settings] : inverse.settings) {
        room.bind(1, number)
            .bind(2, std::int64_t{id})
            .bind(3, std::string_view(settings.name))
            .bind(4, std::int64_t{settings.merge_group})
            .bind(5, std::int64_t{settings.is_locked})
            .run();
    }
    Statement cells(database, "INSERT INTO undo_cells VALUES(?, ?, ?, ?)");
    for (const auto& [tile, bits] : inverse.cells) {
        cells.bind(1, number);
        bind_cell(cells, 2, {tile.first, tile.second});
        cells.bind(4, static_cast<std::int64_t>(bits)).run();
    }
    Statement line(database, "INSERT INTO undo_lines VALUES(?, ?, ?, ?, ?)");
    for (const SplitLine& one : inverse.lines) {
        line.bind(1, number);
        bind_cell(line, 2, one.from);
        bind_cell(line, 4, one.to);
        line.run();
    }
}

}  // namespace quadcut::project
