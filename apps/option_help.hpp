// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/base/option_field.hpp"

namespace quadcut {

/// What a field may be: "0.3 to 100 m", "whole, 1 to 256", "rooms or paper".
[[nodiscard]] std::string range_of(const OptionField& field);

/// The same and the default: "0.3 to 100 m, default 4".
[[nodiscard]] std::string facts_of(const OptionField& field);

}  // namespace quadcut
