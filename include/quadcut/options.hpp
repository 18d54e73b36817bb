// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// What decides the rooms. Nobody needs to set any of it.
#include "quadcut/segment/options.hpp"
