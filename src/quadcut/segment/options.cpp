// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/options.hpp"

#include <string_view>
#include <type_traits>
#include <utility>

namespace quadcut {
namespace {

/// The enumerators' order is the words' order.
template <typename Enum>
Choice choice(Enum& value, std::vector<std::string_view> words) {
    static_assert(std::is_same_v<std::underlying_type_t<Enum>, std::uint8_t>);
    return {reinterpret_cast<std::uint8_t*>(&value), std::move(words)};
}

void add_rooms_fields(RoomsOptions& rooms, std::vector<OptionField>& fields) {
    fields.push_back({"granularity", "", 0.0, 1.0,
                      "how readily a narrowing becomes a cut: 0 few large rooms, 1 many small ones",
                      "", &rooms.granularity});
    fields.push_back({"door_width", "m", 0.3, 100.0,
                      "the widest opening that can separate two rooms", "", &rooms.door_width_m});
    fields.push_back({"rooms.min_component", "m^2", 0.0, 1e6,
                      "connected free space smaller than this is left out", "",
                      &rooms.min_component_m2});
    fields.push_back({"rooms.max_furniture", "m^2", 0.0, 100.0,
                      "isolated obstacles below this size do not count when widths are measured",
                      "", &rooms.max_furniture_m2});
    fields.push_back({"rooms.pieces", "", 0, 0,
                      "what is fused into rooms: basins of the clearance, or spectral pieces "
                      "snapped to them",
                      "", choice(rooms.pieces, {"basins", "spectral"})});
    fields.push_back(
        {"rooms.max_eigenvalue", "1/m^2", 0.0, 100.0,
         "spectral pieces are cut again while their second eigenvalue is smaller; without "
         "unit (0 .. 2) unless the Laplacian is by area",
         "", &rooms.max_eigenvalue_per_m2});
    fields.push_back({"rooms.laplacian", "", 0, 0,
                      "spectral pieces: normalisation of the Laplacian", "",
                      choice(rooms.laplacian, {"degree", "unweighted", "area"})});
    fields.push_back({"rooms.full_clearance", "m", 0.01, 100.0,
                      "spectral pieces: borders with less clearance than this weigh less", "",
                      &rooms.full_clearance_m});
    fields.push_back({"rooms.min_room", "m^2", 0.0, 1e6,
                      "smaller regions join the neighbour with the widest opening", "",
                      &rooms.min_room_m2});
    fields.push_back({"rooms.min_passable", "m", 0.0, 100.0,
                      "free space that is nowhere as wide as this is no room", "",
                      &rooms.min_passable_m});
}

void add_paper_fields(PaperOptions& paper, std::vector<OptionField>& fields) {
    fields.push_back({"submaps", "", 0, 2000, "number of submaps; 0: chosen by silhouette",
                      "eq. (5)", &paper.num_submaps});
    fields.push_back({"paper.max_submaps", "", 2, 1000,
                      "largest number of submaps that the silhouette is tried for", "eq. (9)",
                      &paper.max_submaps});
    fields.push_back({"paper.min_silhouette", "", -1.0, 1.0,
                      "a clustering is accepted from this mean silhouette on", "eq. (9)",
                      &paper.min_silhouette});
    fields.push_back({"paper.laplacian", "", 0, 0, "normalisation of the Laplacian", "eq. (4)",
                      choice(paper.laplacian, {"degree", "unweighted", "area"})});
    fields.push_back({"paper.row_scaling", "", 0, 0, "scaling of the samples before k-means",
                      "eq. (6)", choice(paper.row_scaling, {"none", "unit_length"})});
    fields.push_back({"paper.self_loops", "", 0, 0, "relevance of a node to itself", "rule 1",
                      choice(paper.self_loops, {"none", "own_weight", "largest_weight"})});
    fields.push_back({"paper.components", "", 0, 0, "how connected components are found", "",
                      choice(paper.component_search, {"traversal", "null_space"})});
    fields.push_back({"paper.min_component", "m^2", 0.0, 1e6,
                      "smaller connected components are dropped", "", &paper.min_component_m2});
    fields.push_back({"paper.min_leaf", "m", 0.0, 100.0,
                      "connected components without a leaf as large as this are dropped: slivers",
                      "", &paper.min_leaf_m});
    fields.push_back({"paper.min_submap", "m^2", 0.0, 1e6,
                      "smaller submaps are fused with the most related neighbour", "eq. (11)",
                      &paper.min_submap_m2});
    fields.push_back({"paper.max_submap", "m^2", 0.0, 1e9, "larger submaps are divided", "",
                      &paper.max_submap_m2});
    fields.push_back({"paper.max_route", "", 2, 1e9,
                      "submaps with a longer shortest route, in edges, are divided", "",
                      &paper.max_route_edges});
    fields.push_back({"paper.min_relation", "1/m", 0.0, 1e9,
                      "submaps related more strongly than this are fused", "eq. (11)",
                      &paper.min_relation_per_m});
}

}  // namespace

std::vector<OptionField> option_fields(SegmentOptions& options) {
    std::vector<OptionField> fields;
    fields.push_back({"preset", "", 0, 0,
                      "rooms: as people see them; paper: the method as published", "",
                      choice(options.preset, {"rooms", "paper"})});
    add_rooms_fields(options.rooms, fields);
    add_paper_fields(options.paper, fields);
    fields.push_back({"threads", "", 1, 256, "threads; the result does not depend on it", "",
                      &options.num_threads});
    fields.push_back({"seed", "", 0, 1e15, "seed of the clusterings' starts", "", &options.seed});
    return fields;
}

}  // namespace quadcut
