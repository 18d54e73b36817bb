// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

namespace quadcut {

/// Text as it stands in HTML and SVG, in attributes, too.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace quadcut
