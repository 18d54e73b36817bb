// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// In place of run_reproduce.cpp where src/reproduce is left out of the build.
#include "apps/reproduce.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {

void run_reproduce(const Arguments& /*arguments*/, const reproduce::Options& /*options*/) {
    throw InputError(
        "reproduce: the paper's experiments were left out of this build of quadcut; "
        "build it with -DQUADCUT_REPRODUCE=ON");
}

}  // namespace quadcut
