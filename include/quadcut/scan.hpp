// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// Scans of a laser, and how they become part of a map.
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/scan.hpp"
