// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// Rooms, doors and what there is to say about them.
#include "quadcut/segment/result.hpp"
