// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>

#include "io/file.hpp"
#include "io/file_kind.hpp"

namespace quadcut {

/// An input with what it is: a map (YAML or image) or a laser log.
struct KnownInput {
    io::FileKind kind = io::FileKind::unknown;
    io::InputFile file;
};

/// Reads a map or a log once: a file, a pipe or standard input ("-"), plain or gzip. Anything else
/// (a bag, a folder, ...) is refused after its first bytes: throws InputError that says what it is,
/// and how a map or a log is made of it.
[[nodiscard]] KnownInput read_map_or_log(const std::filesystem::path& path);

/// Reads a log the same way; a map is refused, too.
[[nodiscard]] io::InputFile read_log(const std::filesystem::path& path);

}  // namespace quadcut
