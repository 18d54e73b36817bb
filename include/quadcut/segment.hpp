// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// A finished map cut into rooms.
#include "quadcut/segment/segment.hpp"
