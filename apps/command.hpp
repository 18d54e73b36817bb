// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "apps/arguments.hpp"

namespace quadcut {

/// A sub-command: what it takes, and what it does. `run` prints to standard output, warnings to
/// standard error, and throws when it cannot do what was asked.
struct Command {
    CommandForm form;
    void (*run)(const Arguments& arguments) = nullptr;
    /// In place of `run` where the program's exit code, 0 or 1, is part of the answer.
    int (*answer)(const Arguments& arguments) = nullptr;
};

[[nodiscard]] Command segment_command();
[[nodiscard]] Command map_command();
[[nodiscard]] Command follow_command();
[[nodiscard]] Command rooms_command();
[[nodiscard]] Command export_command();
[[nodiscard]] Command locate_command();
[[nodiscard]] Command route_command();
[[nodiscard]] Command why_command();
[[nodiscard]] Command edit_command();
[[nodiscard]] Command score_command();
[[nodiscard]] Command simulate_command();
[[nodiscard]] Command demo_command();
[[nodiscard]] Command reproduce_command();
[[nodiscard]] Command options_command();
[[nodiscard]] Command version_command();

/// All that this version has, in the order of the help.
[[nodiscard]] std::vector<Command> commands();

}  // namespace quadcut
