// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/version.hpp>

#if QUADCUT_VERSION_MAJOR == 0 && QUADCUT_VERSION_MINOR < 2
#error "this needs quadcut 0.2"
#endif

int main() { std::cout << "quadcut " << quadcut::kVersion << '\n'; }
