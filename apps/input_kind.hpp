// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>

namespace quadcut {

enum class InputKind : std::uint8_t { map, log };

/// Whether a file is a map (YAML, PGM, PNG) or a laser log (CARMEN, plain or gzip): by its suffix,
/// and where that does not say by its first bytes. Throws InputError when the file cannot be read
/// or is neither; a ROS bag is told that this version does not read it.
[[nodiscard]] InputKind find_input_kind(const std::filesystem::path& path);

}  // namespace quadcut
