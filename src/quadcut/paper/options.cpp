// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/options.hpp"

#include "quadcut/base/option_field.hpp"

namespace quadcut {

void add_fields(PaperOptions& options, std::vector<OptionField>& fields) {
    fields.push_back({"submaps", "", 0, 2000,
                      "number of submaps, in the preset rooms of regions; 0: by silhouette, or as "
                      "rooms are found",
                      "eq. (5)", &options.num_submaps});
    fields.push_back({"paper.max_submaps", "", 2, 1000,
                      "largest number of submaps that the silhouette is tried for", "eq. (9)",
                      &options.max_submaps});
    fields.push_back({"paper.min_silhouette", "", -1.0, 1.0,
                      "a clustering is accepted from this mean silhouette on", "eq. (9)",
                      &options.min_silhouette});
    fields.push_back({"paper.laplacian", "", 0, 0, "normalisation of the Laplacian", "eq. (4)",
                      choice(options.laplacian, {"degree", "unweighted", "area"})});
    fields.push_back({"paper.row_scaling", "", 0, 0, "scaling of the samples before k-means",
                      "eq. (6)", choice(options.row_scaling, {"degree", "none", "unit_length"})});
    fields.push_back({"paper.self_loops", "", 0, 0, "relevance of a node to itself", "rule 1",
                      choice(options.self_loops, {"none", "own_weight", "largest_weight"})});
    fields.push_back({"paper.min_component", "m^2", 0.0, 1e6,
                      "smaller connected components are dropped", "", &options.min_component_m2});
    fields.push_back({"paper.min_leaf", "m", 0.0, 100.0,
                      "connected components without a leaf as large as this are dropped: slivers",
                      "", &options.min_leaf_m});
    fields.push_back({"paper.min_submap", "m^2", 0.0, 1e6,
                      "smaller submaps are fused with the most related neighbour", "eq. (11)",
                      &options.min_submap_m2});
    fields.push_back({"paper.max_submap", "m^2", 0.0, 1e9, "larger submaps are divided", "",
                      &options.max_submap_m2});
    fields.push_back({"paper.max_route", "", 2, 1e9,
                      "submaps with a longer shortest route, in edges, are divided", "",
                      &options.max_route_edges});
    fields.push_back({"paper.min_relation", "1/m", 0.0, 1e9,
                      "submaps related more strongly than this are fused", "eq. (11)",
                      &options.min_relation_per_m});
}

}  // namespace quadcut
