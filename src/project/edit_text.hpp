// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "io/json_writer.hpp"
#include "project/edit_record.hpp"

namespace quadcut {

/// rename, merge, split, lock, unlock
[[nodiscard]] std::string_view name_of(EditKind kind);

/// What an edit does: "merge room 12 into room 7".
[[nodiscard]] std::string summary_of(const Edit& edit);
/// What has become of it: "room 12 is now part of room 7".
[[nodiscard]] std::string story_of(const Edit& edit);

/// A line each, the first first; "no edits".
[[nodiscard]] std::string history_text(std::span<const EditRecord> history);
/// The same as a JSON array.
[[nodiscard]] std::string history_json(std::span<const EditRecord> history);
/// The members of the object that is being written.
void write_edit(io::JsonWriter& json, const EditRecord& record);

}  // namespace quadcut
