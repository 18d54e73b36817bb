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

/// How a region is cut when no number of submaps is given.
enum class FirstCut : std::uint8_t {
    /// In half, again and again, as far as halves are little related (cut_in_half()).
    halves,
    /// By k-means first, into the number before the largest relative gap in the spectrum of the
    /// graph's basins; then as above.
    eigengap,
    /// By k-means first, into the number with the best mean silhouette, eqs. (7) to (9); then as
    /// above.
    silhouette,
};

/// The preset `paper`.
struct PaperOptions {
    /// 0: as many as there are.
    std::size_t num_submaps = 0;
    FirstCut first_cut = FirstCut::halves;
    /// The eigengap is looked for between these: what costs less as a normalised cut is one between
    /// submaps, what costs more is none.
    double min_eigenvalue = 0.06;
    double max_eigenvalue = 0.15;
    std::size_t max_submaps = 30;
    double min_silhouette = 0.25;
    LaplacianKind laplacian = LaplacianKind::degree;
    RowScaling row_scaling = RowScaling::degree;
    SelfLoops self_loops = SelfLoops::own_weight;
    double min_component_m2 = 1.0;
    double min_leaf_m = 0.4;
    double min_submap_m2 = 4.0;
    double max_submap_m2 = 300.0;
    std::size_t max_route_edges = 1000;
    double min_relation_per_m = 0.2;
};

/// Adds the options of this stage, bound to the members of `options`, which must outlive the list.
void add_fields(PaperOptions& options, std::vector<OptionField>& fields);

}  // namespace quadcut
