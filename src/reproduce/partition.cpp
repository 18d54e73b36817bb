// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/partition.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/rooms/describe.hpp"

namespace quadcut::reproduce {
namespace {

/// Of one region.
struct Sums {
    double weight = 0.0;
    double cut = 0.0;
    double area_m2 = 0.0;
};

/// How many regions have several parts (4 neighbours) of so many cells.
std::size_t count_broken(const Raster<std::uint32_t>& labels, std::size_t min_cells) {
    const ConnectedParts parts = connected_parts(
        labels, [&](std::size_t i) { return labels.values[i]; }, Connectivity::four);
    const std::vector<std::size_t> num_cells = parts.num_cells();
    std::vector<std::uint32_t> label_of(num_cells.size(), 0);
    parts.for_each_run(
        [&](const CellRun& run, std::size_t first) { label_of[run.part] = labels.values[first]; });
    std::map<std::uint32_t, std::size_t> num_parts;
    for (std::size_t part = 1; part < num_cells.size(); ++part) {
        if (num_cells[part] >= min_cells) ++num_parts[label_of[part]];
    }
    return static_cast<std::size_t>(std::count_if(
        num_parts.begin(), num_parts.end(), [](const auto& entry) { return entry.second > 1; }));
}

}  // namespace

std::vector<std::uint32_t> labels_of_nodes(const MapGraph& graph,
                                           const Raster<std::uint32_t>& labels) {
    std::vector<std::uint32_t> result;
    result.reserve(graph.leaves.nodes.size());
    for (const LeafId id : graph.leaves.nodes) {
        const Leaf& leaf = graph.leaves.table.leaf(id);
        const std::int32_t half = leaf.side_cells() / 2;
        result.push_back(labels.at({leaf.lower_left.x + half, leaf.lower_left.y + half}));
    }
    return result;
}

Raster<std::uint32_t> labels_of_cells(const MapGraph& graph, const GridMap& map,
                                      std::span<const std::uint32_t> clusters) {
    Raster<std::uint32_t> labels(map.states.origin, map.states.width, map.states.height);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        paint_leaf(graph.leaves.table.leaf(graph.leaves.nodes[i]), clusters[i] + 1, labels);
    }
    return labels;
}

Raster<std::uint32_t> labels_of_cells(const Segmentation& rooms) {
    Raster<std::uint32_t> labels(rooms.labels.origin, rooms.labels.width, rooms.labels.height);
    std::copy(rooms.labels.values.begin(), rooms.labels.values.end(), labels.values.begin());
    return labels;
}

std::optional<double> pq_percent(const Raster<std::uint32_t>& labels, const GridMap& map,
                                 const World& world) {
    if (!world.has_truth()) return std::nullopt;
    const Raster<std::uint32_t> truth = labels_at(world.truth_map, world.truth, map);
    Raster<std::uint32_t> judged = labels;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (truth.values[i] == 0 && !world.is_void_judged) judged.values[i] = 0;
    }
    return 100.0 * eval::score_rooms(as_label_image(judged), as_label_image(truth)).pq;
}

std::optional<double> pq_percent(const Segmentation& rooms, const GridMap& map,
                                 const World& world) {
    return pq_percent(labels_of_cells(rooms), map, world);
}

Quality quality_of(const MapGraph& graph, const Raster<std::uint32_t>& labels, const GridMap& map,
                   const World& world) {
    const std::vector<std::uint32_t> label_of = labels_of_nodes(graph, labels);
    std::map<std::uint32_t, Sums> regions;
    for (std::size_t node = 0; node < label_of.size(); ++node) {
        if (label_of[node] == 0) continue;
        Sums& sums = regions[label_of[node]];
        sums.area_m2 += graph.graph.area_m2[node];
        const auto neighbours = graph.graph.neighbours(node);
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            if (neighbours[k] == node) continue;
            const double weight = graph.graph.neighbour_weights(node)[k];
            sums.weight += weight;
            if (label_of[neighbours[k]] != label_of[node]) sums.cut += weight;
        }
    }
    Quality quality;
    quality.num_regions = regions.size();
    double largest_m2 = 0.0;
    double all_m2 = 0.0;
    double weight = 0.0;
    double cut = 0.0;
    for (const auto& [label, sums] : regions) {
        if (sums.weight > 0.0) quality.coupling_percent += 100.0 * sums.cut / sums.weight;
        largest_m2 = std::max(largest_m2, sums.area_m2);
        all_m2 += sums.area_m2;
        weight += sums.weight;
        cut += sums.cut;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, regions.size()));
    quality.coupling_percent /= count;
    if (weight > 0.0) quality.cut_percent = 100.0 * cut / weight;
    if (all_m2 > 0.0) quality.imbalance = largest_m2 / (all_m2 / count);
    const double cell_m2 = map.resolution_m * map.resolution_m;
    quality.num_broken = count_broken(labels, static_cast<std::size_t>(1.0 / cell_m2));
    quality.open_border_percent = open_border_percent(labels, map);
    quality.pq_percent = pq_percent(labels, map, world);
    return quality;
}

std::size_t count_cut_rooms(const Raster<std::uint32_t>& labels, const GridMap& map,
                            const World& world) {
    constexpr double kWhole = 0.85;
    const Raster<std::uint32_t> truth = labels_at(world.truth_map, world.truth, map);
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> shares;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (truth.values[i] != 0 && labels.values[i] != 0) {
            ++shares[truth.values[i]][labels.values[i]];
        }
    }
    std::size_t count = 0;
    for (const auto& [room, regions] : shares) {
        std::size_t all = 0;
        std::size_t largest = 0;
        for (const auto& [region, cells] : regions) {
            all += cells;
            largest = std::max(largest, cells);
        }
        if (static_cast<double>(largest) < kWhole * static_cast<double>(all)) ++count;
    }
    return count;
}

double agreement_percent(const GridMap& map, const Segmentation& rooms,
                         const GridMap& reference_map, const Segmentation& reference) {
    Raster<std::uint32_t> labels = labels_at(map, rooms.labels, reference_map);
    Raster<std::uint32_t> expected = labels_of_cells(reference);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (labels.values[i] == 0) expected.values[i] = 0;
        if (expected.values[i] == 0) labels.values[i] = 0;
    }
    return 100.0 * eval::score_rooms(as_label_image(labels), as_label_image(expected)).pq;
}

double likeness_percent(const Segmentation& rooms, const Segmentation& reference) {
    return 100.0 *
           eval::score_rooms(as_label_image(rooms.labels), as_label_image(reference.labels)).pq;
}

double open_border_percent(const Raster<std::uint32_t>& labels, const GridMap& map) {
    // Half the width of a wide doorway: its middle is no farther from a jamb.
    constexpr float kOpenM = 0.75F;
    Raster<std::uint8_t> open(labels.origin, labels.width, labels.height);
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        open.values[i] = map.states.values[i] == CellState::free ? 1 : 0;
    }
    const Raster<float> clearance = clearance_m(open, map.resolution_m);
    std::size_t all = 0;
    std::size_t wide = 0;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const Cell cell = labels.cell(i);
        for (const Cell other : {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}}) {
            if (labels.values[i] == 0 || !labels.contains(other) || labels.at(other) == 0 ||
                labels.at(other) == labels.values[i]) {
                continue;
            }
            ++all;
            if (clearance.values[i] > kOpenM) ++wide;
        }
    }
    return all == 0 ? 0.0 : 100.0 * static_cast<double>(wide) / static_cast<double>(all);
}

Segmentation as_segmentation(const Raster<std::uint32_t>& labels, const GridMap& map) {
    Segmentation result;
    result.labels = Raster<std::uint16_t>(labels.origin, labels.width, labels.height);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        result.labels.values[i] = static_cast<std::uint16_t>(labels.values[i]);
        count = std::max(count, labels.values[i]);
    }
    result.rooms = describe_rooms(labels, count, map, Layout{}, {});
    return as_submaps(std::move(result));
}

Segmentation as_submaps(Segmentation rooms) {
    for (Room& room : rooms.rooms) {
        room.kind = RoomKind::room;
        room.name = std::to_string(index(room.id));
    }
    rooms.doors.clear();
    return rooms;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> linked_regions(
    const MapGraph& graph, std::span<const std::uint32_t> labels) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> links;
    for (std::size_t node = 0; node < labels.size(); ++node) {
        for (const std::uint32_t other : graph.graph.neighbours(node)) {
            if (labels[node] != 0 && labels[node] < labels[other]) {
                links.emplace(labels[node], labels[other]);
            }
        }
    }
    return links;
}

}  // namespace quadcut::reproduce
