// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/contracted_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace quadcut {
namespace {

/// A wall's line takes so much of the weight of a border that lies in its gap.
constexpr double kWallsKeepApart = 0.97;
/// From this length on a wall at both ends of a gap counts in full, at one end half.
constexpr double kFullWallDm = 5.0;

/// How much of a border lies in the gaps of walls, 0..1.
double share_of_walls(const Saddle& saddle) {
    if (saddle.num_in_line == 0) return 0.0;
    const auto num_in_line = static_cast<double>(saddle.num_in_line);
    const double less_dm = static_cast<double>(saddle.less_wall_dm) / num_in_line;
    const double in_line = num_in_line / static_cast<double>(saddle.num_contacts);
    return in_line * (0.5 + 0.5 * std::min(1.0, less_dm / kFullWallDm));
}

// Departs from the paper: the sum of eq. (2) over the leaves at a border says how long it is, not
// how open. Where it joins as many basins it puts up to five times as much floor into the wrong
// room (docs/decisions/0019-spectral-pieces.md).
double weight(const RegionGraph& regions, std::uint32_t a, std::uint32_t b, const Saddle& saddle) {
    const Point p = regions.centroid(a);
    const Point q = regions.centroid(b);
    // In cells, as the border is. A ring and what it encloses may have one centre.
    const double distance = std::max(1.0, std::hypot(p.x - q.x, p.y - q.y));
    const double openness =
        static_cast<double>(saddle.clearance_m) / std::max(regions.peak_m(a), regions.peak_m(b));
    const auto num_contacts = static_cast<double>(std::max<std::size_t>(1, saddle.num_contacts));
    return num_contacts / distance * openness * openness *
           (1.0 - kWallsKeepApart * share_of_walls(saddle));
}

}  // namespace

ContractedGraph contract(const RegionGraph& regions) {
    ContractedGraph contracted;
    std::vector<double> area_m2;
    std::vector<std::uint32_t> node_of_region(regions.num_pieces() + std::size_t{1}, 0);
    for (std::uint32_t region = 1; region <= regions.num_pieces(); ++region) {
        if (!regions.is_region(region)) continue;
        node_of_region[region] = static_cast<std::uint32_t>(area_m2.size());
        contracted.region_of_node.push_back(region);
        area_m2.push_back(regions.area_m2(region));
    }
    std::vector<WeightedEdge> edges;
    for (const std::uint32_t region : contracted.region_of_node) {
        for (const auto& [other, saddle] : regions.saddles(region)) {
            if (other < region) continue;
            edges.push_back({node_of_region[region], node_of_region[other],
                             weight(regions, region, other, saddle)});
        }
    }
    contracted.graph = build_graph(edges, std::move(area_m2));
    return contracted;
}

void join_pieces(RegionGraph& regions, const ContractedGraph& contracted, const Pieces& pieces,
                 const EarlierDecisions& earlier) {
    // Of each piece, by the earlier room.
    std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t> heir;
    for (std::size_t node = 0; node < contracted.region_of_node.size(); ++node) {
        const std::uint32_t region = contracted.region_of_node[node];
        const auto [own, is_first] =
            heir.emplace(std::pair{pieces.piece_of_node[node], earlier.room_of(region)}, region);
        if (!is_first) regions.join(own->second, region);
    }
}

}  // namespace quadcut
