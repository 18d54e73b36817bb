// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>

#include "apps/arguments.hpp"

namespace quadcut {

/// The flag `-o DIR`, required.
[[nodiscard]] Flag output_flag();

/// The folder that -o names. It is not made yet, but it is checked that it can be, so that a
/// mistake shows before the work is done. Throws InputError when the folder or one above it is a
/// file, and when it cannot be written to. @pre the flag was given
[[nodiscard]] std::filesystem::path output_folder(const Arguments& arguments);
/// The same with a folder to take when -o is missing.
[[nodiscard]] std::filesystem::path output_folder(const Arguments& arguments,
                                                  const std::filesystem::path& otherwise);

}  // namespace quadcut
