// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/spectral/options.hpp"

namespace quadcut {

struct OptionField;

/// Rule 1 of the paper, "each node has max relevance in itself": the weight of a node's edge to
/// itself.
enum class SelfLoops : std::uint8_t {
    /// No loop.
    none,
    /// Eq. (2) with i = j: half the node's side.
    own_weight,
    /// The largest weight that eq. (2) gives to any pair of the nodes: half the largest side.
    largest_weight,
};

/// The preset `paper`.
struct PaperOptions {
    /// 0: chosen by silhouette.
    std::size_t num_submaps = 0;
    std::size_t max_submaps = 30;
    double min_silhouette = 0.25;
    LaplacianKind laplacian = LaplacianKind::degree;
    RowScaling row_scaling = RowScaling::degree;
    SelfLoops self_loops = SelfLoops::own_weight;
    double min_component_m2 = 1.0;
    double min_leaf_m = 0.4;
    double min_submap_m2 = 4.0;
    double max_submap_m2 = 60.0;
    std::size_t max_route_edges = 40;
    double min_relation_per_m = 0.5;
};

/// Adds the options of this stage, bound to the members of `options`, which must outlive the list.
void add_fields(PaperOptions& options, std::vector<OptionField>& fields);

}  // namespace quadcut
