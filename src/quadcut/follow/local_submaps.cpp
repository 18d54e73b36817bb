// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/local_submaps.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quadcut/follow/part_rooms.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/submaps.hpp"
#include "quadcut/paper/visibility.hpp"

namespace quadcut {
namespace {

/// The updated leaves, and those of submaps that were seen with something new.
struct Candidates {
    std::vector<LeafId> nodes;
    std::vector<std::uint32_t> submap_of_node;
    std::vector<bool> is_new;
};

Candidates find_candidates(const SubmapWindow& window, const FreeLeaves& leaves) {
    Candidates result;
    for (const LeafId id : leaves.nodes) {
        const Leaf& leaf = leaves.table.leaf(id);
        const std::int32_t half = leaf.side_cells() / 2;
        const Cell centre{leaf.lower_left.x + half, leaf.lower_left.y + half};
        const std::uint32_t submap = window.submaps.at(centre);
        bool is_updated = submap == 0;
        for (std::int32_t y = 0; y < leaf.side_cells() && !is_updated; ++y) {
            for (std::int32_t x = 0; x < leaf.side_cells() && !is_updated; ++x) {
                is_updated = window.updated.at({leaf.lower_left.x + x, leaf.lower_left.y + y}) != 0;
            }
        }
        if (!is_updated && window.seen.count(submap) == 0) continue;
        result.nodes.push_back(id);
        result.submap_of_node.push_back(submap);
        result.is_new.push_back(is_updated);
    }
    return result;
}

/// The old submaps that go to the temporary list.
std::set<std::uint32_t> relevant_submaps(const SubmapWindow& window,
                                         const std::vector<WeightedEdge>& edges,
                                         const std::vector<std::uint32_t>& submap_of_node,
                                         const std::vector<bool>& is_new) {
    std::set<std::uint32_t> relevant;
    for (const WeightedEdge& edge : edges) {
        // A leaf that is new where a submap was takes that submap along.
        if (!is_new[edge.a] && !is_new[edge.b]) continue;
        for (const std::uint32_t node : {edge.a, edge.b}) {
            const std::uint32_t submap = submap_of_node[node];
            if (window.seen.count(submap) != 0) relevant.insert(submap);
        }
    }
    return relevant;
}

/// Regions that touch, of submaps which people have made one, are joined.
void join_merged(const SubmapWindow& window, LocalCut& cut) {
    const std::vector<std::uint32_t> group_of = groups_of(
        majority_rooms(cut.regions, cut.num_regions, window.submaps), window.merge_groups);
    LabelSets sets;
    for (std::uint32_t region = 1; region <= cut.num_regions; ++region) sets.add();
    for_each_pair(cut.regions, [&](std::size_t i, std::size_t j) {
        const std::uint32_t a = cut.regions.values[i];
        const std::uint32_t b = cut.regions.values[j];
        if (a == b || a == kNotCut || b == kNotCut || group_of[a] == 0) return;
        if (group_of[a] == group_of[b]) sets.join(a, b);
    });
    const std::vector<std::uint32_t> numbers = sets.take_numbers();
    for (std::uint32_t& region : cut.regions.values) {
        if (region != kNotCut) region = numbers[region];
    }
    cut.num_regions = *std::max_element(numbers.begin(), numbers.end());
}

}  // namespace

LocalCut cut_submaps(const SubmapWindow& window, const SegmentOptions& options,
                     const Executor& executor) {
    GridMap map;
    map.resolution_m = window.resolution_m;
    map.states = window.states;
    const FreeLeaves leaves = free_leaves(map);
    const Candidates candidates = find_candidates(window, leaves);
    const std::vector<LeafId>& nodes = candidates.nodes;
    const std::vector<std::uint32_t>& submap_of_node = candidates.submap_of_node;
    const std::vector<bool>& is_new = candidates.is_new;
    const std::vector<WeightedEdge> edges =
        sight_edges(leaves.table, nodes, window.resolution_m, options.paper.self_loops, executor);
    std::set<std::uint32_t> taken = relevant_submaps(window, edges, submap_of_node, is_new);
    // And those that have lost floor.
    for (std::size_t i = 0; i < window.states.values.size(); ++i) {
        const bool is_lost = window.updated.values[i] != 0 && window.submaps.values[i] != 0 &&
                             window.states.values[i] != CellState::free;
        if (is_lost && window.seen.count(window.submaps.values[i]) != 0) {
            taken.insert(window.submaps.values[i]);
        }
    }
    std::vector<std::uint32_t> in_list;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const bool is_taken = taken.count(submap_of_node[node]) != 0;
        // What is new in a submap that is not taken stays with it.
        if (is_taken || (is_new[node] && submap_of_node[node] == 0)) in_list.push_back(node);
    }
    const Graph auxiliary = induced_subgraph(
        build_graph(edges, leaf_areas_m2(leaves.table, nodes, window.resolution_m)), in_list);
    StageClock clock;
    const Submaps submaps = find_submaps(auxiliary, options.paper, options.seed, clock, executor);

    LocalCut cut;
    cut.num_nodes = in_list.size();
    cut.num_regions = submaps.pieces.count;
    cut.regions = Raster<std::uint32_t>(window.states.origin, window.states.width,
                                        window.states.height, kNotCut);
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        if (taken.count(window.submaps.values[i]) != 0) cut.regions.values[i] = 0;
    }
    for (std::size_t i = 0; i < submaps.nodes.size(); ++i) {
        paint_leaf(leaves.table.leaf(nodes[in_list[submaps.nodes[i]]]),
                   submaps.pieces.piece_of_node[i] + 1, cut.regions);
    }
    if (!window.merge_groups.empty()) join_merged(window, cut);
    return cut;
}

}  // namespace quadcut
