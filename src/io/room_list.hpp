// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "io/json_writer.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// How much a table shows.
struct TableLimits {
    std::size_t rows = std::numeric_limits<std::size_t>::max();
    /// Characters of a name.
    std::size_t name_length = std::numeric_limits<std::size_t>::max();
};

/// The rooms as a table with a line each, the largest first: id, name, kind (glimpses have none),
/// area, doors. Columns are aligned for a terminal. Of more rooms than `limits` has rows the rest
/// is counted in a last line, of longer names the end is left out. Empty without rooms.
[[nodiscard]] std::string room_table(const Segmentation& segmentation,
                                     const TableLimits& limits = {});

/// How many rooms there are, and their area; and how many glimpses, which are none.
struct RoomTotals {
    std::size_t num_rooms = 0;
    std::size_t num_glimpses = 0;
    double area_m2 = 0.0;
};

[[nodiscard]] RoomTotals totals_of(const Segmentation& segmentation);

/// The members num_rooms, num_glimpses, num_doors, area_m2, rooms and doors of the object that is
/// being written: what a summary in JSON says of a segmentation.
void write_rooms_and_doors(JsonWriter& json, const Segmentation& segmentation);

}  // namespace quadcut::io
