// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string_view>

namespace quadcut::project {

/// Makes an SQLite file of these bytes at a name that is free: whole, or not at all, whenever the
/// program is killed. What a killed program has left beside an earlier file of this name is taken
/// away. Of several programs that do this at once one wins. Throws InputError, which names `path`,
/// for the others, and when it cannot be written.
void make_database_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace quadcut::project
