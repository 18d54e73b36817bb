// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "sim/building.hpp"

namespace quadcut::sim {

/// The well-structured workplace of the paper's experiments (Fig 11): a rectangle of 16 by 10 m
/// with five inner submaps, a room in the middle over the whole height and two rooms on either
/// side of it, each with one door to the middle. No furniture.
[[nodiscard]] Building paper_workplace(double resolution_m = 0.05);

}  // namespace quadcut::sim
