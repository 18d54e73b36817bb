// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

namespace quadcut::io {

/// Of the files that write_results() and write_map() write; it grows when a reader of the old ones
/// could not read the new ones.
inline constexpr int kFormatVersion = 1;

}  // namespace quadcut::io
