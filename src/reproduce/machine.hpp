// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

namespace quadcut::reproduce {

/// What times were measured on.
struct Machine {
    /// As /proc/cpuinfo names it; "unknown" where there is none.
    std::string cpu;
    unsigned num_cores = 1;
    /// Name and version.
    std::string compiler;
    /// How many programs wanted a core in the last minute; 0 where that is not known.
    double load = 0.0;
};

[[nodiscard]] Machine this_machine();

}  // namespace quadcut::reproduce
