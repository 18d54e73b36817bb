// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/random.hpp"
#include "sim/furnisher.hpp"
#include "sim/piece.hpp"

namespace quadcut::sim {

/// The make of a room as a laser half a metre above the floor sees it: of office chairs the post,
/// but not the star of feet.
[[nodiscard]] Make seen_from_above(Make make);

/// What is built of furniture, before the rest is placed: desks in rows with partitions between
/// them, shelves along walls and corridors, cupboards beside doors. `amount`: 0..1.
void add_fixtures(Furnisher& furnisher, double amount, Random& random);

/// What stands about after the rest has its place: chairs pushed away, boxes, bins.
void add_litter(Furnisher& furnisher, double amount, Random& random);

}  // namespace quadcut::sim
