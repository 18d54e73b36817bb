// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/rooms.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/contracted_graph.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/rooms/hierarchy.hpp"
#include "quadcut/rooms/label_tally.hpp"
#include "quadcut/rooms/open_space.hpp"
#include "quadcut/rooms/regions.hpp"
#include "quadcut/rooms/spectral_pieces.hpp"

namespace quadcut {
namespace {

/// What is enclosed by an outline up to this size is the inside of furniture.
constexpr double kMaxPocketM2 = 4.0;

/// The regions with cells on the edge of a window.
std::vector<bool> regions_on_edge(const Raster<std::uint32_t>& pieces, const RegionGraph& regions) {
    std::vector<bool> result(regions.num_pieces() + std::size_t{1}, false);
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        if (pieces.values[i] != 0 && is_on_edge(pieces, i)) {
            result[regions.region_of(pieces.values[i])] = true;
        }
    }
    return result;
}

/// `cut.rooms` holds the pieces at first. The finest regions are tidied; what they fuse into is
/// measured before, since `regions` look at the pieces as they were, perhaps in that very raster;
/// only how many are left of them is known after.
void fuse_into_rooms(const FloorToCut& floor, const RoomsOptions& options,
                     const EarlierDecisions& earlier, const Executor& executor,
                     RegionGraph& regions, RoomsCut& cut, Hierarchy* hierarchy) {
    Raster<std::uint32_t>& labels = cut.rooms;
    fuse_small_regions(regions, kMinPieceM2, options.min_passable_m, earlier);
    Fuser(regions, options.door_width_m, executor, earlier.for_cuts_only())
        .fuse_below(fuse_threshold(1.0));
    fuse_small_regions(regions, options.min_room_m2, options.min_passable_m, earlier);
    const std::vector<bool> goes_on =
        floor.add_beyond ? regions_on_edge(cut.pieces, regions) : std::vector<bool>{};
    const std::vector<std::uint32_t> finest = regions_of_pieces(regions);
    std::optional<RegionGraph> finest_regions;
    if (hierarchy != nullptr) finest_regions.emplace(regions);
    const double threshold = fuse_threshold(options.granularity);
    if (floor.least_rooms == 0) {
        Fuser(regions, options.door_width_m, executor, earlier).fuse_below(threshold);
    }
    renumber(labels, finest, executor);
    connect_regions(labels, goes_on, executor);
    drop_impassable(labels, cut.clearance_m, options.min_passable_m, goes_on, executor);
    // What is enclosed by furniture belongs to the room around it; rooms stay connected.
    const Adoption adoption =
        adopt_pockets(labels, floor.states, floor.resolution_m, kMaxPocketM2, executor);
    drop_without_floor(labels, floor.states, executor);
    if (adoption.is_any) connect_regions(labels, goes_on, executor);
    if (hierarchy != nullptr) {
        *hierarchy = build_hierarchy(labels, std::move(*finest_regions), options.door_width_m,
                                     adoption.enclosures, earlier);
    }
    if (floor.least_rooms != 0) {
        Fuser fuser(regions, options.door_width_m, executor, earlier);
        fuse_to_number(fuser, regions, labels, adoption.enclosures, threshold, floor.least_rooms);
    }
    relabel(regions, labels, adoption.enclosures, executor);
}

}  // namespace

RoomsCut cut_into_rooms(FloorToCut floor, const RoomsOptions& options, StageClock& clock,
                        const Executor& executor, Hierarchy* hierarchy) {
    RoomsCut cut;
    clock.begin("clearance");
    // The search for lines is not parallel throughout: beside it there is work for another thread.
    parallel_for(executor, 2, 1, [&](std::size_t task, std::size_t) {
        if (task == 0) {
            cut.lines =
                find_wall_lines(floor.kept, floor.resolution_m, options.door_width_m, executor);
        } else {
            cut.free_clearance_m = clearance_m(floor.kept, floor.resolution_m, executor);
        }
    });
    Raster<std::uint8_t> open = open_space(std::move(floor.kept), floor.resolution_m,
                                           options.max_furniture_m2, cut.lines, executor);
    cut.clearance_m = clearance_m(open, floor.resolution_m, executor);
    clock.begin("cut");
    Basins basins = build_basins(cut.free_clearance_m, floor.resolution_m, executor);
    basins.count = split_at_lines(cut.lines, basins.labels, executor);
    spread_labels(open, basins.labels);
    open = {};
    cut.rooms = std::move(basins.labels);
    cut.num_pieces = basins.count;
    clock.begin("graph");
    EarlierDecisions earlier;
    if (!floor.earlier.values.empty()) {
        cut.num_pieces = cut_where_rooms_met(cut.rooms, cut.num_pieces, floor.earlier);
        earlier = EarlierDecisions(cut.rooms, cut.num_pieces, floor.earlier);
    }
    // A whole map may be so large that there is no room for both.
    const bool keeps_pieces = floor.add_beyond || hierarchy != nullptr || floor.least_rooms != 0;
    if (keeps_pieces) cut.pieces = cut.rooms;
    RegionGraph regions(
        keeps_pieces ? cut.pieces : cut.rooms, cut.num_pieces,
        {cut.clearance_m, cut.free_clearance_m, floor.states, cut.lines, floor.resolution_m},
        executor);
    cut.report.num_leaves = cut.num_pieces;
    cut.report.num_edges = regions.num_saddles();
    if (floor.add_beyond) floor.add_beyond(cut.pieces, regions);
    if (options.pieces == PieceSource::spectral) {
        const ContractedGraph contracted = contract(regions);
        clock.begin("eigen");
        Pieces pieces = cut_spectrally(contracted.graph, options.min_room_m2, executor);
        join_pieces(regions, contracted, pieces, earlier);
        cut.report.eigen = std::move(pieces.eigen);
    }
    if (floor.add_beyond) cut.joined_pieces = regions_of_pieces(regions);
    clock.begin("fuse");
    fuse_into_rooms(floor, options, earlier, executor, regions, cut, hierarchy);
    return cut;
}

}  // namespace quadcut
