// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

namespace quadcut::io {

/// Of the files that write_results() and write_map() write; it grows when a reader of the old ones
/// could not read the new ones.
inline constexpr int kFormatVersion = 1;
/// Of report.json; 2: what became of rooms has the words of updates.jsonl (born, retired), and why.
inline constexpr int kReportVersion = 2;

}  // namespace quadcut::io
