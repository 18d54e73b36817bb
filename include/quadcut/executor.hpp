// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// How many threads and which device do the work.
#include "quadcut/base/parallel.hpp"
#include "quadcut/base/run_options.hpp"
