// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// Maps: finished ones (GridMap), and those that grow with what is seen (OccupancyMap).
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/occupancy_map.hpp"
