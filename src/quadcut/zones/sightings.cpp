// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/sightings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "quadcut/map/line_walk.hpp"
#include "quadcut/map/scan_cells.hpp"

namespace quadcut {
namespace {

/// Labels with what 8 x 8 of them share: most of what a scan sees lies inside one room.
class TiledLabels {
public:
    explicit TiledLabels(const Raster<std::uint16_t>& labels)
        : labels_(labels), shared_(Box{tile_of(labels.box().low), tile_of(labels.box().high)}) {
        for (std::size_t i = 0; i < shared_.values.size(); ++i) {
            const Box cells = cells_of_tiles({shared_.cell(i), shared_.cell(i)});
            shared_.values[i] = at(cells.low);
            for_each_cell(cells, [&](Cell cell) {
                if (at(cell) != shared_.values[i]) shared_.values[i] = kMixed;
            });
        }
    }

    /// 0 outside.
    [[nodiscard]] std::uint32_t at(Cell cell) const {
        return labels_.contains(cell) ? labels_.at(cell) : 0U;
    }

    /// Adds the cells of a tile, bit 8 y + x, to those of their labels.
    void count(Cell tile, std::uint64_t rows, std::vector<std::uint32_t>& cells_of_label) const {
        if (!shared_.contains(tile)) return;
        const std::uint32_t shared = shared_.at(tile);
        if (shared != kMixed) {
            cells_of_label[shared] += static_cast<std::uint32_t>(std::popcount(rows));
            return;
        }
        const Cell low = first_cell_of(tile);
        for (; rows != 0; rows &= rows - 1) {
            const int place = std::countr_zero(rows);
            ++cells_of_label[at({low.x + place % kTileSide, low.y + place / kTileSide})];
        }
    }

private:
    static constexpr std::uint32_t kMixed = kMaxRoomId + 1;
    const Raster<std::uint16_t>& labels_;
    Raster<std::uint32_t> shared_;
};

Sighting sighting_of(const Scan& scan, const GridMap& map, const TiledLabels& labels,
                     const IntegrateOptions& options, std::vector<std::uint32_t>& cells_of_label) {
    const Pose pose = compose(inverse(map.map_from_image), scan.world_from_sensor);
    const Point sensor{pose.x / map.resolution_m, pose.y / map.resolution_m};
    const ScanCells cells = cells_of(beams_of(scan, pose.yaw_rad, map.resolution_m, options),
                                     sensor, scan.angle_step_rad);
    std::fill(cells_of_label.begin(), cells_of_label.end(), 0U);
    const Cell origin = tile_of(cells.free.origin());
    for (std::int32_t y = 0; y < cells.free.height() / kTileSide; ++y) {
        for (std::int32_t x = 0; x < cells.free.width() / kTileSide; ++x) {
            const std::uint64_t rows = cells.free.tile_rows(x, y) & ~cells.hit.tile_rows(x, y);
            if (rows != 0) labels.count({origin.x + x, origin.y + y}, rows, cells_of_label);
        }
    }
    Sighting sighting{
        {scan.world_from_sensor.x, scan.world_from_sensor.y}, labels.at(cell_of(sensor)), {}};
    for (std::uint32_t label = 1; label < cells_of_label.size(); ++label) {
        if (cells_of_label[label] == 0) continue;
        sighting.floors.push_back({label, cells_of_label[label]});
    }
    return sighting;
}

}  // namespace

std::vector<Sighting> sightings_of(const NextScan& next, const GridMap& map,
                                   const Segmentation& rooms, const IntegrateOptions& options,
                                   const Executor& executor) {
    // Scans are read one by one, and looked at side by side.
    constexpr std::size_t kAtATime = 256;
    constexpr std::size_t kChunk = 16;
    const TiledLabels labels(rooms.labels);
    std::vector<Sighting> sightings;
    std::vector<Scan> scans;
    do {
        scans.clear();
        while (scans.size() < kAtATime) {
            std::optional<Scan> scan = next();
            if (!scan) break;
            scans.push_back(*std::move(scan));
        }
        const std::size_t num_done = sightings.size();
        sightings.resize(num_done + scans.size());
        parallel_for(executor, scans.size(), kChunk, [&](std::size_t first, std::size_t last) {
            std::vector<std::uint32_t> cells_of_label(rooms.rooms.size() + 1);
            for (std::size_t i = first; i < last; ++i) {
                sightings[num_done + i] =
                    sighting_of(scans[i], map, labels, options, cells_of_label);
            }
        });
    } while (scans.size() == kAtATime);
    return sightings;
}

std::vector<std::uint32_t> labels_seen(const Sighting& sighting, const GridMap& map,
                                       const Segmentation& rooms) {
    const double cell_m2 = map.resolution_m * map.resolution_m;
    std::vector<std::uint32_t> seen;
    for (const SeenFloor& floor : sighting.floors) {
        const double room_m2 = rooms.rooms[floor.room - std::size_t{1}].area_m2;
        if (is_seen(floor.num_cells * cell_m2, room_m2)) seen.push_back(floor.room);
    }
    return seen;
}

Covisibility covisibility_of(std::span<const Sighting> sightings, const Segmentation& rooms) {
    Covisibility counts;
    for (const Sighting& sighting : sightings) {
        std::vector<SeenFloor> floors = sighting.floors;
        for (SeenFloor& floor : floors) {
            const RoomId id = rooms.rooms[floor.room - std::size_t{1}].id;
            floor.room = static_cast<std::uint32_t>(id);
        }
        count_scan(counts, floors);
    }
    return counts;
}

}  // namespace quadcut
