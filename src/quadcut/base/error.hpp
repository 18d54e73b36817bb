// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <stdexcept>
#include <string>

namespace quadcut {

/// Bad input: a file, a scan or an option that cannot be used. The message names the file, the
/// place in it (line or byte) and what was expected. The command line exits with 2.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A numerical method did not reach its accuracy. The inputs are untouched.
class NumericalError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace quadcut
