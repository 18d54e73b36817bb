// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quadcut {

/// One line on standard error, `quadcut: ...`. Control characters are shown as '?', so that it
/// stays one line whatever a file is called.
void print_error(std::string_view message);

/// `quadcut: warning: ...`, a line each.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace quadcut
