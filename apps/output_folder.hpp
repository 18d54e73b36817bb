// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "io/file_batch.hpp"

namespace quadcut {

/// The flag `-o DIR`, required.
[[nodiscard]] Flag output_flag();

/// The flag `--force`.
[[nodiscard]] Flag force_flag();

/// The folder that -o names, or `otherwise`. @pre one of them is there
[[nodiscard]] std::filesystem::path output_folder(const Arguments& arguments,
                                                  const std::filesystem::path& otherwise = {});

/// What is going to be written into output_folder(). Nothing is made yet, but it is checked that
/// all `files` can be, so that a mistake shows before the work is done. None of them may be a file
/// that the arguments name as one that is read, be it an operand or the value of a flag. Throws
/// InputError when the folder or one above it is a file, when it cannot be written to, and as
/// FileBatch::require_free().
[[nodiscard]] io::FileBatch begin_output(const Arguments& arguments,
                                         const std::vector<std::string>& files,
                                         const std::filesystem::path& otherwise = {});

}  // namespace quadcut
