// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "quadcut/base/option_field.hpp"

namespace quadcut::io {

/// Sets the option called `name` from text. Throws InputError that names the option, what was
/// expected, and for an unknown name the nearest known one.
void set_option(const std::vector<OptionField>& fields, std::string_view name,
                std::string_view text);

/// The value as text that set_option() reads back.
[[nodiscard]] std::string option_text(const OptionField& field);

/// The word of `known` with the fewest edits to `word`; empty when all are far from it.
[[nodiscard]] std::string_view nearest_word(std::string_view word,
                                            const std::vector<std::string_view>& known);

}  // namespace quadcut::io
