// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

namespace quadcut {

/// "quadcut segment 'my map.yaml' -o rooms": words as they are typed into a shell.
[[nodiscard]] std::string command_line(std::span<const std::string> words);

}  // namespace quadcut
