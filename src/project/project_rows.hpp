// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "project/database.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/options.hpp"

namespace quadcut::project {

inline constexpr std::int64_t kMaxRoom = 0xfffffffe;
/// As OccupancyMap's cells.
inline constexpr std::int64_t kMaxCoordinate = std::int64_t{1} << 28;

/// A cell whose x is in the given column and whose y is in the next.
[[nodiscard]] Cell cell_at(const Statement& row, int column);

/// Binds a cell's x at a place and its y at the next.
void bind_cell(Statement& statement, int place, Cell cell);

/// Whether a file has a table that earlier versions do not have.
[[nodiscard]] bool has_table(const Database& database, std::string_view name);

/// Writes all that is known but tiles, in place of what was, and these tiles. @pre a transaction is
/// open.
void write_state(const Database& database, const FollowedMap& state, std::span<const Cell> tiles);
/// Reads it again. Throws InputError for rows that cannot be.
[[nodiscard]] FollowedMap read_state(const Database& database, const FollowOptions& options);

}  // namespace quadcut::project
