// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/map/raster.hpp"

namespace quadcut::reproduce {

struct VoronoiOptions {
    /// A critical point has the least clearance on the graph within this.
    double critical_radius_m = 1.2;
    /// And the graph is at least so much wider somewhere within that radius on two sides.
    double min_widening = 1.15;
    /// A narrower place is no part of the graph; a wider one is no door.
    double min_clearance_m = 0.15;
    double max_clearance_m = 1.0;
    /// Smaller regions join the neighbour with which they share most border.
    double min_region_m2 = 4.0;
};

struct VoronoiRegions {
    /// 1 .. num_regions in each open cell that has one; 0 elsewhere.
    Raster<std::uint32_t> regions;
    std::uint32_t num_regions = 0;
    /// Cells of the Voronoi graph, and the critical points that cut it.
    std::size_t num_graph_cells = 0;
    std::size_t num_critical = 0;
};

/// The classic segmentation by a Voronoi graph (Thrun 1998), kept simple: the graph is the open
/// cells whose nearest obstacles lie on opposite sides; where its clearance is least, a line from
/// the one obstacle to the other cuts the open space; what is then connected is a region, and small
/// ones are merged. A baseline: no furniture, no model of a door.
/// `open`: 1 = free. O(cells log cells + critical points * cells within the radius).
[[nodiscard]] VoronoiRegions voronoi_regions(const Raster<std::uint8_t>& open, double resolution_m,
                                             const VoronoiOptions& options = {});

}  // namespace quadcut::reproduce
