// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/schema.hpp"

#include <array>

namespace quadcut::project {

std::span<const Table> tables() {
    static constexpr std::array<Table, 18> kTables{{
        {"changes", "CREATE TABLE changes(x INTEGER, y INTEGER, cells INTEGER)"},
        {"covisibility",
         "CREATE TABLE covisibility(room_a INTEGER, room_b INTEGER, scans REAL, "
         "PRIMARY KEY(room_a, room_b)) WITHOUT ROWID",
         4},
        {"door_lines",
         "CREATE TABLE door_lines(id INTEGER PRIMARY KEY, ax INTEGER, ay INTEGER, bx INTEGER, "
         "by INTEGER, x1 REAL, y1 REAL, x2 REAL, y2 REAL, width_m REAL, room_a_width_m REAL, "
         "room_b_width_m REAL, confidence REAL)",
         3},
        {"doors",
         "CREATE TABLE doors(seq INTEGER PRIMARY KEY, room_a INTEGER, room_b INTEGER, "
         "ax INTEGER, ay INTEGER, bx INTEGER, by INTEGER, clearance_m REAL)"},
        {"edits",
         "CREATE TABLE edits(seq INTEGER PRIMARY KEY, scan INTEGER, kind TEXT, room INTEGER, "
         "other INTEGER, name TEXT, from_x INTEGER, from_y INTEGER, to_x INTEGER, to_y INTEGER)"},
        {"lineage",
         "CREATE TABLE lineage(seq INTEGER PRIMARY KEY, scan INTEGER, event TEXT, room INTEGER, "
         "other INTEGER, reason TEXT)"},
        {"meta", "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID"},
        {"options", "CREATE TABLE options(name TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID"},
        {"poses", "CREATE TABLE poses(seq INTEGER PRIMARY KEY, x REAL, y REAL, yaw_rad REAL)", 4},
        {"rooms",
         "CREATE TABLE rooms(id INTEGER PRIMARY KEY, name TEXT, merge_group INTEGER, locked "
         "INTEGER, "
         "area_m2 REAL, peak_m REAL, low_x INTEGER, low_y INTEGER, high_x INTEGER, "
         "high_y INTEGER, announced_m2 REAL, decided_cells INTEGER, next_block INTEGER)"},
        {"seen", "CREATE TABLE seen(room INTEGER PRIMARY KEY)"},
        {"split_lines",
         "CREATE TABLE split_lines(seq INTEGER PRIMARY KEY, from_x INTEGER, from_y INTEGER, "
         "to_x INTEGER, to_y INTEGER)"},
        {"tiles",
         "CREATE TABLE tiles(x INTEGER, y INTEGER, log_odds BLOB, rooms BLOB, "
         "cut_free INTEGER, PRIMARY KEY(y, x)) WITHOUT ROWID"},
        {"undo", "CREATE TABLE undo(edit INTEGER PRIMARY KEY, state TEXT, border TEXT)", 2},
        {"undo_cells", "CREATE TABLE undo_cells(edit INTEGER, x INTEGER, y INTEGER, cells INTEGER)",
         2},
        {"undo_lines",
         "CREATE TABLE undo_lines(edit INTEGER, from_x INTEGER, from_y INTEGER, to_x INTEGER, "
         "to_y INTEGER)",
         2},
        {"undo_rooms",
         "CREATE TABLE undo_rooms(edit INTEGER, room INTEGER, name TEXT, merge_group INTEGER, "
         "locked INTEGER)",
         2},
        {"updates", "CREATE TABLE updates(seq INTEGER PRIMARY KEY, line TEXT)"},
    }};
    return kTables;
}

}  // namespace quadcut::project
