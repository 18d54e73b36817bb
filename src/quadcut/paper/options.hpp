// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/paper/visibility.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

struct OptionField;

/// How the connected components of the paper's graph are found.
enum class ComponentSearch : std::uint8_t { traversal, null_space };

/// The preset `paper`.
struct PaperOptions {
    /// 0: chosen by silhouette.
    std::size_t num_submaps = 0;
    std::size_t max_submaps = 30;
    double min_silhouette = 0.25;
    LaplacianKind laplacian = LaplacianKind::degree;
    RowScaling row_scaling = RowScaling::none;
    SelfLoops self_loops = SelfLoops::own_weight;
    ComponentSearch component_search = ComponentSearch::traversal;
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
