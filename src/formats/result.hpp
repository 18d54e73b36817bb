// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/floor_plan.hpp"
#include "io/palette.hpp"
#include "io/room_pairs.hpp"
#include "io/run_info.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::formats {

/// A result as its files are made of it, with what they share: it does not change, and any number
/// of formats may read it at a time.
class Result {
public:
    /// All are kept by reference. `updates` are the lines of updates.jsonl, if a robot was
    /// followed. Throws std::logic_error when the map is empty, labels or doors name rooms that are
    /// not there, or ids are not different ones in 1 .. kMaxRoomId.
    Result(const GridMap& map, const Segmentation& rooms, const io::RunInfo& info,
           std::string_view updates = {});

    [[nodiscard]] const GridMap& map() const { return map_; }
    /// Their labels are for exactly the cells of the map.
    [[nodiscard]] const Segmentation& rooms() const { return cut_ ? *cut_ : rooms_; }
    [[nodiscard]] const io::RunInfo& info() const { return info_; }
    [[nodiscard]] std::string_view updates() const { return updates_; }
    [[nodiscard]] const std::vector<io::RoomPair>& near_rooms() const { return near_rooms_; }
    /// Of each room.
    [[nodiscard]] const std::vector<io::Rgb>& colors() const { return colors_; }
    /// What the pictures draw, laid out when one of them first asks.
    [[nodiscard]] const draw::FloorPlan& plan() const;
    [[nodiscard]] Executor executor() const { return Executor{info_.num_threads}; }
    /// Since the result was handed over.
    [[nodiscard]] double elapsed_ms() const;

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const GridMap& map_;
    const Segmentation& rooms_;
    /// The same, where the labels were of other cells.
    std::optional<Segmentation> cut_;
    const io::RunInfo& info_;
    std::string_view updates_;
    std::vector<io::RoomPair> near_rooms_;
    std::vector<io::Rgb> colors_;
    mutable std::once_flag is_laid_out_;
    mutable draw::FloorPlan plan_;
};

}  // namespace quadcut::formats
