// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>

#include "io/file_kind.hpp"
#include "io/input.hpp"

namespace quadcut {

/// An input with what it is: a map (YAML or image) or a laser log.
struct KnownInput {
    io::FileKind kind = io::FileKind::unknown;
    io::Input input;
};

/// Opens a map or a log: a file, a pipe or standard input ("-"), plain or gzip. Anything else
/// (a bag, a folder, ...) is refused after its first bytes: throws InputError that says what it is,
/// and how a map or a log is made of it.
[[nodiscard]] KnownInput open_map_or_log(const std::filesystem::path& path);

/// Opens a log the same way; a map is refused, too.
[[nodiscard]] io::Input open_log(const std::filesystem::path& path);

}  // namespace quadcut
