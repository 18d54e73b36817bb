// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/result.hpp"
#include "reproduce/map_graph.hpp"
#include "reproduce/world.hpp"

namespace quadcut::reproduce {

/// What can be said of any division of a map, whatever method made it.
struct Quality {
    std::size_t num_regions = 0;
    /// Regions of several parts of a square metre or more that no free cells of the region join:
    /// they lie on both sides of a wall.
    std::size_t num_broken = 0;
    /// The mean over regions of the weight of the edges that leave it, over that of all its edges,
    /// percent: low coupling is a small number. Loops do not count.
    double coupling_percent = 0.0;
    /// The weight of the edges between regions over that of all edges, percent.
    double cut_percent = 0.0;
    /// The largest region's area over the mean.
    double imbalance = 0.0;
    /// Of the border between regions, percent: what lies across open floor, more than 0.75 m from
    /// all that stands, as in the middle of no doorway of 1.5 m.
    double open_border_percent = 0.0;
    /// Against the true rooms, percent; nothing where they are not known.
    std::optional<double> pq_percent;
};

/// The label at the middle of each node's leaf.
[[nodiscard]] std::vector<std::uint32_t> labels_of_nodes(const MapGraph& graph,
                                                         const Raster<std::uint32_t>& labels);
/// Labels by node as labels by cell; those of nodes count from 0 on, those of cells from 1.
[[nodiscard]] Raster<std::uint32_t> labels_of_cells(const MapGraph& graph, const GridMap& map,
                                                    std::span<const std::uint32_t> clusters);
[[nodiscard]] Raster<std::uint32_t> labels_of_cells(const Segmentation& rooms);

/// 0 is no region. @pre `labels` covers the cells of the map that the graph is of.
[[nodiscard]] Quality quality_of(const MapGraph& graph, const Raster<std::uint32_t>& labels,
                                 const GridMap& map, const World& world);

/// Panoptic quality, percent, of labels of a map against the world's true rooms.
[[nodiscard]] std::optional<double> pq_percent(const Raster<std::uint32_t>& labels,
                                               const GridMap& map, const World& world);

/// The same of a result on the cells of `map`.
[[nodiscard]] std::optional<double> pq_percent(const Segmentation& rooms, const GridMap& map,
                                               const World& world);

/// True rooms of which no region holds 85 % of what is labelled: they are cut apart.
[[nodiscard]] std::size_t count_cut_rooms(const Raster<std::uint32_t>& labels, const GridMap& map,
                                          const World& world);

/// How two divisions agree where both say something: PQ in percent. The first is resampled to the
/// cells of the second.
[[nodiscard]] double agreement_percent(const GridMap& map, const Segmentation& rooms,
                                       const GridMap& reference_map, const Segmentation& reference);

/// PQ, percent, of a division against another one of the same cells.
[[nodiscard]] double likeness_percent(const Segmentation& rooms, const Segmentation& reference);

/// The regions, 1 to 65535, as submaps without doors, to be drawn.
[[nodiscard]] Segmentation as_segmentation(const Raster<std::uint32_t>& labels, const GridMap& map);

/// Rooms as submaps are drawn: by number and in clear colours, whatever their shape, and without
/// doors: where two submaps meet there need be none.
[[nodiscard]] Segmentation as_submaps(Segmentation rooms);

/// Quality::open_border_percent of labels on the cells of a map; 0 without a border. O(cells).
[[nodiscard]] double open_border_percent(const Raster<std::uint32_t>& labels, const GridMap& map);

/// Pairs of regions that an edge of G joins (the paper's relevance), a < b.
[[nodiscard]] std::set<std::pair<std::uint32_t, std::uint32_t>> linked_regions(
    const MapGraph& graph, std::span<const std::uint32_t> labels);

}  // namespace quadcut::reproduce
