// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "apps/command.hpp"

namespace quadcut {

/// What `quadcut help` prints: the commands that there are.
[[nodiscard]] std::string help_text();

/// The command of that name. Throws InputError that names the nearest one, or says that it is not
/// in this version.
[[nodiscard]] Command find_command(std::string_view name);

/// The command that the words begin with; the rest is for it. Throws InputError as above, and says
/// what the whole line was probably meant to be where a file or a flag stands before the command,
/// or another command after it.
[[nodiscard]] Command command_of(std::span<const std::string> words);

}  // namespace quadcut
