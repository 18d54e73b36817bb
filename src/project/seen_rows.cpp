// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/seen_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "project/project_rows.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::project {

void write_covisibility(const Database& database, const FollowedMap& state) {
    Statement(database, "DELETE FROM covisibility").run();
    Statement insert(database, "INSERT INTO covisibility VALUES(?, ?, ?)");
    for (const auto& [rooms, scans] : state.covisibility.scans) {
        insert.bind(1, std::int64_t{rooms.first})
            .bind(2, std::int64_t{rooms.second})
            .bind(3, scans)
            .run();
    }
}

void read_covisibility(const Database& database, FollowedMap& state) {
    if (!has_table(database, "covisibility")) return;
    Statement row(database,
                  "SELECT room_a, room_b, scans FROM covisibility ORDER BY room_a, room_b");
    while (row.step()) {
        const std::pair rooms(static_cast<std::uint32_t>(row.integer(0, 1, kMaxRoom)),
                              static_cast<std::uint32_t>(row.integer(1, 1, kMaxRoom)));
        state.covisibility.scans[rooms] = row.number(2);
    }
}

void read_way(const Database& database, FollowedMap& state) {
    if (!has_table(database, "poses")) return;
    const double farthest_m = static_cast<double>(kMaxCoordinate) * state.map.resolution_m();
    Statement row(database, "SELECT x, y FROM poses ORDER BY seq");
    for (std::size_t count = 1; row.step(); ++count) {
        if (count > state.num_scans) throw InputError("there are more poses than scans");
        const Cell cell = state.map.cell_at({row.number(0, farthest_m), row.number(1, farthest_m)});
        if (state.way.empty() || state.way.back() != cell) state.way.push_back(cell);
    }
}

}  // namespace quadcut::project
