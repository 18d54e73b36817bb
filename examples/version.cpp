// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/version.hpp>

static_assert(QUADCUT_VERSION_MAJOR == 0 && QUADCUT_VERSION_MINOR == 2);

int main() { std::cout << "quadcut " << quadcut::kVersion << '\n'; }
// Prints: quadcut 0.2.0
