// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/part_tallies.hpp"

#include "draw/floor_cells.hpp"

namespace quadcut::draw {

std::vector<Box> bounds_of(const ConnectedParts& parts) {
    std::vector<Box> bounds(parts.count + std::size_t{1});
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        const auto y = static_cast<std::int32_t>(first / static_cast<std::size_t>(parts.width));
        bounds[run.part].include({{static_cast<std::int32_t>(run.begin), y},
                                  {static_cast<std::int32_t>(run.end) - 1, y}});
    });
    return bounds;
}

std::vector<BorderTally> tally_borders(const Raster<std::uint16_t>& ground,
                                       const Raster<std::uint8_t>& mask,
                                       const ConnectedParts& parts,
                                       const std::vector<bool>& wanted) {
    std::vector<BorderTally> tallies(parts.count + std::size_t{1});
    const auto width = static_cast<std::size_t>(ground.width);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        if (!wanted[run.part]) return;
        const std::uint32_t length = run.end - run.begin;
        // What lies beside a cell of the mask and is in the mask is of the same part.
        std::uint32_t num_edges = 0;
        std::uint32_t num_room_edges = 0;
        std::uint32_t num_wall_edges = 0;
        const auto look = [&](std::size_t begin, std::size_t count) {
            for (std::size_t i = begin; i < begin + count; ++i) {
                num_edges += mask.values[i] == 0 ? 1 : 0;
                num_room_edges += is_room(ground.values[i]) ? 1 : 0;
                num_wall_edges += ground.values[i] == kWall ? 1 : 0;
            }
        };
        if (run.begin > 0) look(first - 1, 1);
        if (run.end < width) look(first + length, 1);
        if (first >= width) look(first - width, length);
        if (first + width < ground.values.size()) look(first + width, length);
        BorderTally& tally = tallies[run.part];
        tally.num_cells += length;
        tally.num_edges += num_edges;
        tally.num_room_edges += num_room_edges;
        tally.num_wall_edges += num_wall_edges;
    });
    return tallies;
}

}  // namespace quadcut::draw
