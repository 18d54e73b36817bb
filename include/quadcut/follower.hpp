// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// Rooms of a building while it is explored.
#include "quadcut/follow/follower.hpp"
