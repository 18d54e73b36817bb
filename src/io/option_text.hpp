// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "quadcut/base/option_field.hpp"

namespace quadcut::io {

/// Sets the option called `name` from text. Throws InputError that names the option, what was
/// expected and what was probably meant: the nearest known name, the nearest word that may be
/// chosen, the number without its unit.
void set_option(const std::vector<OptionField>& fields, std::string_view name,
                std::string_view text);

/// The value as text that set_option() reads back.
[[nodiscard]] std::string option_text(const OptionField& field);

}  // namespace quadcut::io
