// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "project/database.hpp"
#include "quadcut/follow/follower_state.hpp"

namespace quadcut::project {

inline constexpr std::int64_t kMaxRoom = 0xfffffffe;

/// A cell whose x is in the given column and whose y is in the next.
[[nodiscard]] Cell cell_at(const Statement& row, int column);

/// Binds a cell's x at a place and its y at the next.
void bind_cell(Statement& statement, int place, Cell cell);

/// Writes what a follower remembers: tiles are added to those that are there, all else replaces
/// what was. @pre a transaction is open.
void write_state(const Database& database, const FollowerState& state);
/// Reads it again, with all tiles. Throws InputError for rows that cannot be.
[[nodiscard]] FollowerState read_state(const Database& database);

}  // namespace quadcut::project
