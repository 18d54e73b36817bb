// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string_view>

namespace quadcut {

/// Throws InputError that says what kind of folder stands where `expected` was: a ROS 2 bag, a
/// result of quadcut, or one with maps and logs in it, which are named.
[[noreturn]] void refuse_folder(const std::filesystem::path& folder, std::string_view expected);

}  // namespace quadcut
