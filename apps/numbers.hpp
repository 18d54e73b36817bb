// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// A number among the operands; `what` stands in the message. Throws InputError unless it is a
/// finite one.
[[nodiscard]] double number_of(const std::string& word, const std::string& what);
/// Two of them, metres in the map frame.
[[nodiscard]] Point point_of(const std::string& x, const std::string& y);

}  // namespace quadcut
