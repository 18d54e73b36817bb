// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

namespace quadcut::io {

/// Text that stands for itself in XML and HTML, also within quotes. Control characters, which XML
/// has no way to write, go.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace quadcut::io
