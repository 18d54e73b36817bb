// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/scan.hpp"
#include "quadcut/segment/result.hpp"
#include "reproduce/figure.hpp"
#include "reproduce/map_graph.hpp"

namespace quadcut::reproduce {

// Pictures of maps as PNG, about a thousand pixels long, of the part that is known.

/// The floor plan with its rooms. `links`: red lines between points of the map's image, in cells,
/// the paper's connectivity of submaps.
[[nodiscard]] Picture plan_picture(std::string file, const GridMap& map, const Segmentation& rooms,
                                   std::string caption,
                                   std::span<const std::pair<Point, Point>> links = {});

/// The quadtree: each leaf with its outline; free ones light, obstacles dark.
[[nodiscard]] Picture quadtree_picture(std::string file, const GridMap& map, std::string caption);

/// The graph G: a line for each edge between the centres of two leaves.
[[nodiscard]] Picture graph_picture(std::string file, const MapGraph& graph, const GridMap& map,
                                    std::string caption);

/// The end points of all beams that hit something, and the robot's way.
[[nodiscard]] Picture scans_picture(std::string file, std::span<const Scan> scans,
                                    const GridMap& map, std::string caption);

/// The entries of a symmetric matrix as dots.
[[nodiscard]] Picture matrix_picture(
    std::string file, std::size_t size,
    std::span<const std::pair<std::uint32_t, std::uint32_t>> entries, std::string caption);

/// The middle of each region's area, cells of the map's image; [label - 1].
[[nodiscard]] std::vector<Point> middles_of(const Segmentation& rooms);

}  // namespace quadcut::reproduce
