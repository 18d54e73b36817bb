// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "bench/baseline.hpp"
#include "bench/border_length.hpp"
#include "bench/building_case.hpp"
#include "bench/cases.hpp"
#include "bench/door_score.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

// All that is measured on one simulated building.
namespace quadcut {

/// Rows: the true kind; columns: the found one; unknown, room, corridor, hall.
using KindCounts = std::array<std::array<std::size_t, 4>, 4>;

/// A found door that is a true one.
struct MatchedDoor {
    double distance_m = 0.0;
    double width_error_m = 0.0;
    /// How much of that error the map has already.
    double map_error_m = 0.0;
    double border_ratio = 0.0;
    double border_over_width = 0.0;
    bool is_open_passage = false;
    std::size_t truth = 0;
};

/// A building, its rooms and its doors against the truth.
struct CaseResult {
    BuildingCase chosen;
    eval::RoomScore rooms;
    eval::RoomScore baseline;
    DoorScore doors;
    std::vector<MatchedDoor> matched;
    KindCounts kinds{};
    /// Rooms that are in no true one: shafts that the map draws free.
    std::size_t num_in_shafts = 0;

    /// The PQ of the rooms, were none found in shafts.
    [[nodiscard]] double pq_without_shafts() const {
        const double sum = rooms.rooms + rooms.truth;
        return rooms.pq * sum / (sum - static_cast<double>(num_in_shafts));
    }
};

/// The kinds of true rooms and of the rooms that they are matched with, IoU > 0.5.
inline KindCounts count_kinds(const MappedBuilding& mapped, const Segmentation& found) {
    std::vector<std::size_t> num_true(mapped.building.rooms.size() + 1, 0);
    std::vector<std::size_t> num_found(found.rooms.size() + 1, 0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;
    for (std::size_t i = 0; i < mapped.truth.values.size(); ++i) {
        const std::uint32_t truth = mapped.truth.values[i];
        const std::uint32_t room = found.labels.values[i];
        if (truth == 0 || room == 0) continue;
        ++num_true[truth];
        ++num_found[room];
        ++shared[{truth, room}];
    }
    KindCounts counts{};
    for (const auto& [pair, count] : shared) {
        const auto [truth, room] = pair;
        if (num_true[truth] <= io::kIgnoredRegionPixels) continue;
        if (2 * count <= num_true[truth] + num_found[room] - count) continue;
        ++counts[static_cast<std::size_t>(mapped.building.rooms[truth - 1].kind)]
                [static_cast<std::size_t>(found.rooms[room - 1].kind)];
    }
    return counts;
}

/// How many found rooms share less than a hundredth of their cells with true ones.
inline std::size_t count_in_shafts(const MappedBuilding& mapped, const Segmentation& found) {
    std::vector<std::size_t> num_cells(found.rooms.size() + 1, 0);
    std::vector<std::size_t> num_true(found.rooms.size() + 1, 0);
    for (std::size_t i = 0; i < mapped.truth.values.size(); ++i) {
        ++num_cells[found.labels.values[i]];
        if (mapped.truth.values[i] != 0) ++num_true[found.labels.values[i]];
    }
    std::size_t count = 0;
    for (std::size_t room = 1; room < num_cells.size(); ++room) {
        const bool is_counted = num_cells[room] > io::kIgnoredRegionPixels;
        if (is_counted && 100 * num_true[room] < num_cells[room]) ++count;
    }
    return count;
}

/// Draws the building, maps it, cuts the map into rooms by the defaults, and scores them.
inline CaseResult measure(const BuildingCase& chosen) {
    const MappedBuilding mapped = map_building(chosen);
    const Segmentation found = segment(mapped.map, {}, RunOptions{1}, mapped.trajectory);
    CaseResult result;
    result.chosen = chosen;
    const io::LabelImage truth = as_label_image(mapped.truth);
    result.rooms = eval::score_rooms(as_label_image(found.labels), truth);
    result.baseline =
        eval::score_rooms(as_label_image(watershed_baseline(mapped.map, mapped.trajectory)), truth);
    result.doors = DoorScorer(mapped, found).score();
    const Pose image_from_map = inverse(mapped.map.map_from_image);
    const Beside beside(mapped.map);
    for (const DoorPair& pair : result.doors.pairs) {
        const Door& door = found.doors[pair.predicted];
        const sim::TrueDoor& truth_door = mapped.building.doors[pair.truth];
        const BorderLine border =
            measure_border(found.labels, door, image_from_map, mapped.map.resolution_m);
        result.matched.push_back(
            {pair.distance_m, door.width_m - truth_door.width_m,
             beside.width_on_map_m(truth_door.jamb_1, truth_door.jamb_2) - truth_door.width_m,
             border.ratio(), border.length_cells * mapped.map.resolution_m / door.width_m,
             truth_door.is_open_passage, pair.truth});
    }
    result.kinds = count_kinds(mapped, found);
    result.num_in_shafts = count_in_shafts(mapped, found);
    return result;
}

}  // namespace quadcut
