// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/cut_submaps.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "quadcut/follow/part_rooms.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/submaps.hpp"
#include "quadcut/paper/visibility.hpp"

namespace quadcut {
namespace {

/// Leaves of up to this side, in cells, are the same in a window as in the whole map.
constexpr std::int32_t kBlock = 128;

/// Grows a box to such blocks of the quadtree.
Box whole_blocks(const Box& box) {
    constexpr std::int32_t kMask = kBlock - 1;
    const auto down = [](std::int32_t at) { return at - (at & kMask); };
    return {{down(box.low.x), down(box.low.y)},
            {down(box.high.x) + kMask, down(box.high.y) + kMask}};
}

bool is_updated(const FollowedMap& followed, Cell cell) {
    const Cell tile = tile_of(cell);
    return followed.changed_tiles.count({tile.x, tile.y}) != 0;
}

/// The updated leaves, and those of submaps that were seen with something new.
struct Candidates {
    std::vector<LeafId> nodes;
    std::vector<std::uint32_t> submap_of_node;
    std::vector<bool> is_new;
};

Candidates find_candidates(const FollowedMap& followed, const Window& window,
                           const FreeLeaves& leaves) {
    Candidates result;
    for (const LeafId id : leaves.nodes) {
        const Leaf& leaf = leaves.table.leaf(id);
        const Cell low = leaf.lower_left;
        const std::int32_t side = leaf.side_cells();
        const std::uint32_t submap = window.rooms.at({low.x + side / 2, low.y + side / 2});
        bool is_new = submap == 0;
        // All cells of a tile are updated, or none.
        for (std::int32_t y = 0; y < side && !is_new; y += kTileSide) {
            for (std::int32_t x = 0; x < side && !is_new; x += kTileSide) {
                is_new = is_updated(followed, {low.x + x, low.y + y});
            }
        }
        if (!is_new && followed.seen.count(submap) == 0) continue;
        result.nodes.push_back(id);
        result.submap_of_node.push_back(submap);
        result.is_new.push_back(is_new);
    }
    return result;
}

/// The old submaps that go to the temporary list.
std::set<std::uint32_t> relevant_submaps(const FollowedMap& followed, const Window& window,
                                         const std::vector<WeightedEdge>& edges,
                                         const Candidates& candidates) {
    std::set<std::uint32_t> relevant;
    const auto take = [&](std::uint32_t submap) {
        if (followed.seen.count(submap) != 0) relevant.insert(submap);
    };
    for (const WeightedEdge& edge : edges) {
        // A leaf that is new where a submap was takes that submap along.
        if (!candidates.is_new[edge.a] && !candidates.is_new[edge.b]) continue;
        take(candidates.submap_of_node[edge.a]);
        take(candidates.submap_of_node[edge.b]);
    }
    // And those that have lost floor.
    for (std::size_t i = 0; i < window.states.values.size(); ++i) {
        const std::uint32_t submap = window.rooms.values[i];
        if (submap == 0 || window.states.values[i] == CellState::free) continue;
        if (is_updated(followed, window.states.cell(i))) take(submap);
    }
    return relevant;
}

/// Regions that touch, of submaps which people have made one, are joined.
void join_merged(const FollowedMap& followed, const Window& window, WindowCut& cut) {
    const std::vector<std::uint32_t> group_of =
        groups_of(majority_rooms(cut.regions, cut.num_regions, window.rooms), followed);
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

void note_seen(FollowedMap& followed, Preset preset, const std::vector<Cell>& tiles) {
    if (preset != Preset::paper) return;
    for (const Cell tile : tiles) {
        const RoomTile& cells = followed.cells.tile(tile);
        std::uint32_t last = 0;
        for (int i = 0; i < static_cast<int>(kTileCells); ++i) {
            const std::uint32_t room = cells.rooms[static_cast<std::size_t>(i)];
            if (room != 0 && room != last) followed.seen.insert(room);
            if (room == 0 && (cells.cut_free >> i & 1) != 0) {
                followed.seen_roomless.include(cells_of_tiles({tile, tile}));
            }
            last = room;
        }
    }
}

Window window_of_seen(const FollowedMap& followed) {
    Box box = followed.seen_roomless;
    for (const auto& [at, count] : followed.changed_tiles) {
        // And the tiles beside it.
        box.include(cells_of_tiles({{at.first - 1, at.second - 1}, {at.first + 1, at.second + 1}}));
    }
    for (const std::uint32_t submap : followed.seen) {
        const auto room = followed.rooms.find(submap);
        if (room != followed.rooms.end()) box.include(room->second.box);
    }
    box = whole_blocks(box);
    return read_window(followed, box, box);
}

WindowCut cut_submaps(const FollowedMap& followed, const Window& window,
                      const SegmentOptions& options, const Executor& executor) {
    GridMap map;
    map.resolution_m = followed.map.resolution_m();
    map.states = window.states;
    const FreeLeaves leaves = free_leaves(map);
    const Candidates candidates = find_candidates(followed, window, leaves);
    const std::vector<LeafId>& nodes = candidates.nodes;
    const std::vector<WeightedEdge> edges =
        sight_edges(leaves.table, nodes, map.resolution_m, options.paper.self_loops, executor);
    const std::set<std::uint32_t> taken = relevant_submaps(followed, window, edges, candidates);
    std::vector<std::uint32_t> in_list;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const std::uint32_t submap = candidates.submap_of_node[node];
        // What is new in a submap that is not taken stays with it.
        if (taken.count(submap) != 0 || (candidates.is_new[node] && submap == 0)) {
            in_list.push_back(node);
        }
    }
    const Graph auxiliary = induced_subgraph(
        build_graph(edges, leaf_areas_m2(leaves.table, nodes, map.resolution_m)), in_list);
    StageClock clock;
    const Submaps submaps = find_submaps(auxiliary, options.paper, options.seed, clock, executor);

    WindowCut cut;
    cut.num_nodes = in_list.size();
    cut.cells_read = window.states.values.size();
    cut.num_regions = submaps.pieces.count;
    cut.regions = Raster<std::uint32_t>(window.states.box(), kNotCut);
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        if (taken.count(window.rooms.values[i]) != 0) cut.regions.values[i] = 0;
    }
    for (std::size_t i = 0; i < submaps.nodes.size(); ++i) {
        paint_leaf(leaves.table.leaf(nodes[in_list[submaps.nodes[i]]]),
                   submaps.pieces.piece_of_node[i] + 1, cut.regions);
    }
    const bool is_any_merged =
        std::any_of(followed.rooms.begin(), followed.rooms.end(),
                    [](const auto& entry) { return entry.second.merge_group != 0; });
    if (is_any_merged) join_merged(followed, window, cut);
    return cut;
}

}  // namespace quadcut
