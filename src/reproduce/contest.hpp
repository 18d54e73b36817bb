// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "quadcut/segment/result.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/figure.hpp"
#include "reproduce/map_graph.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/world.hpp"

namespace quadcut::reproduce {

/// A method's division of a map.
struct Contender {
    Segmentation rooms;
    Raster<std::uint32_t> labels;
    double elapsed_ms = 0.0;
    /// What it is made of: leaves, basins, cells of a Voronoi graph.
    std::size_t num_units = 0;
    Quality quality;
};

/// The same map, divided by four methods.
struct Contest {
    /// Without loops.
    MapGraph graph;
    Contender paper;
    Contender rooms;
    /// k-means of the leaves' positions, as many clusters as the preset `paper` has submaps.
    Contender positions;
    Contender voronoi;
};

/// `num_submaps`: what the preset `paper` is told; 0: it finds it, and only what the
/// robot's way crosses counts.
[[nodiscard]] Contest hold_contest(const World& world, std::size_t num_submaps, const Setup& setup);

/// A column for each method; `paper_regions` is what the paper says of its number of submaps.
[[nodiscard]] Table table_of(const Contest& contest, const Value& paper_ms,
                             const Value& paper_regions);

/// Pictures of all four, NAME_paper.png and so on; the first as wide as the page.
[[nodiscard]] std::vector<Picture> pictures_of(const Contest& contest, const World& world,
                                               const std::string& name);

}  // namespace quadcut::reproduce
