// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

#include "apps/arguments.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {

// What is wrong with a command line, and what was probably meant.

/// A flag that the command does not have, or not yet; `next` is the word after it, or empty.
[[nodiscard]] InputError unknown_flag(const CommandForm& form, const Setting& given,
                                      const std::string& next);

/// Throws unless `value`, which stands after --set, is NAME=VALUE with a name that is known.
void check_setting(const CommandForm& form, const std::string& value, const std::string& next);

/// Throws unless there are as many operands as the command takes; `words` are all that was given.
void check_operands(const CommandForm& form, const Arguments& arguments,
                    std::span<const std::string> words);

/// Throws unless the flags that must be there are.
void check_required(const CommandForm& form, const Arguments& arguments,
                    std::span<const std::string> words);

}  // namespace quadcut
