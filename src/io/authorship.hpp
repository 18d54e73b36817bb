// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string_view>

namespace quadcut::io {

/// Stands in a comment near the top of what quadcut writes as a PGM, SVG, page, log or poses.
inline constexpr std::string_view kAuthorComment = "Written by quadcut";
/// The text chunk of its PNGs: keyword and text, parted by a zero byte.
inline constexpr std::string_view kAuthorChunk{"Software\0quadcut", 16};

/// Whether a file that begins so is a project: an SQLite file with its application id.
[[nodiscard]] bool begins_project(std::string_view first_bytes);

/// Whether the first bytes of a file say that quadcut has written it: by one of the above, or by
/// the `format_version` of its YAML and JSON files, or by the application id of a project.
[[nodiscard]] bool is_own_work(std::string_view first_bytes);

/// The same of a file; of a .g2o, of the .zones of the same name that is written with it. False
/// when it cannot be read, or is no regular file. O(1).
[[nodiscard]] bool is_own_file(const std::filesystem::path& path);

}  // namespace quadcut::io
