// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "apps/arguments.hpp"

namespace quadcut {

/// The shortest way to write a flag with its value: "-o DIR".
[[nodiscard]] std::string short_form(const Flag& flag);

/// One line: `quadcut segment MAP|LOG -o DIR [options]`.
[[nodiscard]] std::string usage_of(const CommandForm& form);

/// What `quadcut NAME --help` prints: usage, flags, examples.
[[nodiscard]] std::string help_of(const CommandForm& form);

}  // namespace quadcut
