// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "quadcut/map/integrate_options.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// No beam is used further.
inline constexpr double kMaxRangeCells = 8192.0;

/// The most cells that the box around all that scans see may have: 820 m x 820 m at 5 cm.
inline constexpr std::int64_t kMaxCellsOfScans = std::int64_t{1} << 28;

/// The cells of one tile that a scan speaks of, bit 8 y + x for cell (x, y) of the tile.
struct TileEvidence {
    Cell tile;
    std::uint64_t miss = 0;
    std::uint64_t hit = 0;
};

/// The longest reading of a scan that says something; 0: none.
[[nodiscard]] float longest_reading_m(const Scan& scan);

/// Whole tiles, in cells, that hold all that a scan can speak of: as far around the sensor as its
/// longest reading. Empty when no beam says anything. Throws InputError when the pose cannot be
/// used, as evidence_of() does.
[[nodiscard]] Box cells_in_reach(const OccupancyMap& map, const Scan& scan,
                                 const IntegrateOptions& options = {});

/// What a scan says of the map: one miss for each cell that it saw free (cells_of), one hit for
/// each cell with an end point; the hit wins. Invalid beams and those without a return say nothing.
///
/// Beyond `trusted_range_m` a small error of the yaw moves a beam by cells. So there, walls that
/// the map is sure of are not cleared, and a beam that would have to pass through one ends before
/// it. O(cells that beams cross + cells of the bounding box / 64). Throws InputError when the
/// scan's pose is not finite or beyond the map's limits, or when the usable range is no positive
/// number of cells or more than 8192.
[[nodiscard]] std::vector<TileEvidence> evidence_of(const OccupancyMap& map, const Scan& scan,
                                                    const IntegrateOptions& options = {});

/// Adds evidence to the log-odds, without commit(). Throws InputError, with the map unchanged, when
/// it would pass the map's limits.
void add_evidence(OccupancyMap& map, std::span<const TileEvidence> evidence,
                  const IntegrateOptions& options = {});

/// Adds a scan to the map and commits. The update covers all that the scan speaks of (paper
/// eq. 10). Errors as above; the map is then unchanged.
MapUpdate integrate_scan(OccupancyMap& map, const Scan& scan, const IntegrateOptions& options = {});

/// Called after each scan with how many are done.
using ScanProgress = std::function<void(std::size_t num_done)>;
/// Gives scans one by one; nothing at the end.
using NextScan = std::function<std::optional<Scan>()>;

/// The map of a whole log: the same as integrate_scan one by one. Errors name the scan, from 0 on.
[[nodiscard]] OccupancyMap map_from_scans(std::span<const Scan> scans, double resolution_m,
                                          const IntegrateOptions& options = {},
                                          const ScanProgress& progress = {});
[[nodiscard]] OccupancyMap map_from_scans(const NextScan& next, double resolution_m,
                                          const IntegrateOptions& options = {},
                                          const ScanProgress& progress = {});

}  // namespace quadcut
