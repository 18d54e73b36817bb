// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

#include "apps/command.hpp"

namespace quadcut {

/// What `quadcut help` prints: the commands that there are.
[[nodiscard]] std::string help_text();

/// The command of that name. Throws InputError that names the nearest one, or says that it is not
/// in this version.
[[nodiscard]] Command find_command(std::string_view name);

}  // namespace quadcut
