// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "project/database.hpp"
#include "quadcut/follow/edit.hpp"

namespace quadcut::store {

/// Whether an edit holds. What is dropped was undone, and others were made since: it cannot be made
/// again. A fixed edit was made by a version that did not keep how to undo it.
enum class EditState : std::uint8_t { done, undone, dropped, fixed };

/// An edit of people: a row that stays.
struct EditRecord {
    /// rename, merge, split, lock, unlock
    std::string kind;
    RoomId room{};
    RoomId other{};
    std::string name;
    SplitLine line;
    /// The scans that had been followed.
    std::size_t scan = 0;
    EditState state = EditState::done;
    /// 1, 2, ... in the order in which they were made.
    std::int64_t number = 0;
};

/// All edits, the first first. Throws InputError for rows that cannot be.
[[nodiscard]] std::vector<EditRecord> read_edits(const Database& database);
/// Adds one; what was undone before is dropped. @pre a transaction is open.
void write_edit(const Database& database, const EditRecord& record, const Reversal& inverse);
/// What takes an edit back, or makes it again when it is undone.
[[nodiscard]] Reversal read_inverse(const Database& database, const EditRecord& record);
/// Says that an edit was undone, or made again, and what is its inverse now.
/// @pre a transaction is open.
void write_inverse(const Database& database, std::int64_t number, EditState state,
                   const Reversal& inverse);

}  // namespace quadcut::store
