// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "tests/e2e/program.hpp"

namespace quadcut::test {

/// A terminal of so many columns that a program is started in.
struct Terminal {
    int num_columns = 80;  ///< 0: it does not say
    /// What TERM says.
    std::string kind = "xterm";
    /// What COLUMNS says.
    std::string columns = "80";
    /// Ctrl-C is pressed when this has been printed; empty: never.
    std::string interrupt_at = {};
};

/// Runs quadcut in a terminal. `out` has all that was printed, as the terminal got it: lines end
/// with "\r\n". Exit codes as those of run_process().
Outcome run_in_terminal(const std::vector<std::string>& arguments, const Terminal& terminal);

/// What was drawn one over the other, without control sequences; lines that ended are left out.
std::vector<std::string> drawn_lines(const std::string& printed);

}  // namespace quadcut::test
