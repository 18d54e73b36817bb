// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/version.hpp"

#include <iostream>

#include "apps/command.hpp"

namespace quadcut {

Command version_command() {
    CommandForm form;
    form.name = "version";
    form.text = "Prints the version.";
    form.examples = {"quadcut version", "quadcut --version"};
    return {form, [](const Arguments&) { std::cout << "quadcut " << kVersion << '\n'; }};
}

}  // namespace quadcut
