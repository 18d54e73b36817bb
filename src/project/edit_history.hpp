// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "project/database.hpp"
#include "project/edit_record.hpp"
#include "quadcut/follow/edit.hpp"

namespace quadcut::project {

/// All edits, the first first. Throws InputError for rows that cannot be.
[[nodiscard]] std::vector<EditRecord> read_edits(const Database& database, double resolution_m);
/// Adds one, and returns its number; what was undone before is dropped. @pre a transaction is open.
[[nodiscard]] std::int64_t write_edit(const Database& database, const EditRecord& record,
                                      const Reversal& inverse);
/// What takes an edit back, or makes it again when it is undone.
[[nodiscard]] Reversal read_inverse(const Database& database, const EditRecord& record);
/// Says that an edit was undone, or made again, and what is its inverse now.
/// @pre a transaction is open.
void write_inverse(const Database& database, std::int64_t number, EditState state,
                   const Reversal& inverse);

}  // namespace quadcut::project
