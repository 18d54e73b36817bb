// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/rooms.hpp"

#include "quadcut/segment/hierarchy.hpp"
#include "quadcut/segment/regions.hpp"

namespace quadcut {
namespace {

/// What is enclosed by an outline up to this size is the inside of furniture.
constexpr double kMaxPocketM2 = 4.0;

/// By region instead of by piece.
std::vector<bool> by_region(const std::vector<bool>& goes_on, const RegionGraph& regions) {
    std::vector<bool> result(goes_on.size(), false);
    for (std::uint32_t piece = 0; piece < goes_on.size(); ++piece) {
        if (goes_on[piece]) result[regions.region_of(piece)] = true;
    }
    return result;
}

}  // namespace

Raster<std::uint32_t> fuse_into_rooms(const RoomsInput& input, const RoomsOptions& options,
                                      const Window& window, const Executor& executor,
                                      RegionGraph& regions, Hierarchy* hierarchy) {
    const DoorRule rule{options.door_width_m, options.fuse, options.min_ratio, window.decided};
    const auto measure_ahead = [&] {
        if (rule.by == FuseRule::model) {
            regions.measure_all(rule.max_width_m, executor, window.decided);
        }
    };
    measure_ahead();
    Fuser(regions, rule).fuse_below(fuse_threshold(1.0));
    fuse_small_regions(regions, options.min_room_m2, options.min_passable_m);
    Raster<std::uint32_t> labels = input.pieces;
    relabel(regions, labels);
    const std::vector<bool> goes_on = by_region(window.goes_on, regions);
    connect_regions(labels, goes_on);
    drop_impassable(labels, input.clearance_m, options.min_passable_m, goes_on);
    // What is enclosed by furniture belongs to the room around it; rooms stay connected.
    const Adoption adoption = adopt_pockets(
        labels, input.free, find_pockets(labels, input.free, input.resolution_m, kMaxPocketM2));
    drop_without_floor(labels, input.free);
    if (adoption.is_any) connect_regions(labels, goes_on);
    if (hierarchy != nullptr) {
        *hierarchy = build_hierarchy(labels, regions, rule, adoption.enclosures);
    }
    measure_ahead();
    Fuser(regions, rule).fuse_below(fuse_threshold(options.granularity));
    relabel(regions, labels, adoption.enclosures);
    return labels;
}

}  // namespace quadcut
