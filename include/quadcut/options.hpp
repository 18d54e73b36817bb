// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// What decides the rooms. Nobody needs to set any of it.
#include "quadcut/base/option_field.hpp"
#include "quadcut/follow/options.hpp"
#include "quadcut/segment/options.hpp"
