// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string>

namespace quadcut::io {

/// Whether write_results has written there: a folder with a rooms.yaml.
[[nodiscard]] bool has_result(const std::filesystem::path& folder);

/// Whether it is a file that begins as projects do.
[[nodiscard]] bool is_project(const std::filesystem::path& path);

/// What is there instead, and the folder that was probably meant: "no such folder", "a project of
/// quadcut", "no rooms.yaml in it (map.pgm, map.yaml): did you mean 'DIR/out'?".
[[nodiscard]] std::string found_instead_of_result(const std::filesystem::path& path);

}  // namespace quadcut::io
