// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/option_field.hpp"
#include "quadcut/graph/visibility.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// `rooms`: rooms as people see them. `paper`: the method as published.
enum class Preset : std::uint8_t { rooms, paper };

/// What is fused into rooms: the basins of the clearance, or the pieces of the spectral over-cut,
/// snapped to the basins.
enum class PieceSource : std::uint8_t { basins, spectral };

/// How the connected components of the paper's graph are found.
enum class ComponentSearch : std::uint8_t { traversal, null_space };

/// The preset `rooms`. Two knobs are public; the rest is for experiments.
struct RoomsOptions {
    double granularity = 0.5;
    double door_width_m = 4.0;
    double min_component_m2 = 4.0;
    double max_furniture_m2 = 0.3;
    PieceSource pieces = PieceSource::basins;
    double max_eigenvalue_per_m2 = 0.8;
    LaplacianKind laplacian = LaplacianKind::area;
    double full_clearance_m = 1.5;
    double min_room_m2 = 1.5;
    double min_passable_m = 0.4;
};

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

struct SegmentOptions {
    Preset preset = Preset::rooms;
    RoomsOptions rooms;
    PaperOptions paper;
    std::size_t num_threads = 2;
    std::size_t seed = 1;
    /// Whether the result carries the hierarchy of granularities; preset `rooms`.
    bool with_hierarchy = false;
    /// Does parts of the work, with the same result; not owned.
    Accelerator* accelerator = nullptr;
};

/// Every option by name, bound to the members of `options`, which must outlive the list.
[[nodiscard]] std::vector<OptionField> option_fields(SegmentOptions& options);

}  // namespace quadcut
