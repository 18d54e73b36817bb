// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// What is thrown: InputError, NumericalError; std::logic_error for a bug of the caller.
#include "quadcut/base/error.hpp"
