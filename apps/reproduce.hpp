// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "apps/arguments.hpp"
#include "reproduce/reproduce.hpp"

namespace quadcut {

/// Measures and writes the page; the data that was asked for is checked first, so that a mistake
/// shows at once. Throws InputError where src/reproduce is left out of the build.
void run_reproduce(const Arguments& arguments, const reproduce::Options& options);

}  // namespace quadcut
