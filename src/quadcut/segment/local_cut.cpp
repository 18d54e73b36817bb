// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/local_cut.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/segment/basins.hpp"
#include "quadcut/segment/open_space.hpp"
#include "quadcut/segment/region_graph.hpp"
#include "quadcut/segment/rooms.hpp"

namespace quadcut {
namespace {

/// The connected free cells that are large enough, that have been a room, or that may go on beyond
/// the window.
Raster<std::uint8_t> cells_to_cut(const LocalWindow& window, double min_component_m2) {
    const Raster<CellState>& states = window.states;
    const ConnectedParts parts = connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free; },
        [](std::size_t, std::size_t) { return true; });
    const double cell_m2 = window.resolution_m * window.resolution_m;
    std::vector<bool> is_kept;
    for (const std::size_t size : parts.num_cells()) {
        is_kept.push_back(static_cast<double>(size) * cell_m2 >= min_component_m2);
    }
    is_kept.front() = false;
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const std::uint32_t part = parts.labels.values[i];
        if (part != 0 && (window.rooms.values[i] != 0 || is_on_edge(states, i))) {
            is_kept[part] = true;
        }
    }
    Raster<std::uint8_t> kept(states.origin, states.width, states.height);
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        kept.values[i] = is_kept[parts.labels.values[i]] ? 1 : 0;
    }
    return kept;
}

/// The room that most cells of each piece had; 0 where most had none.
std::vector<std::uint32_t> majority_rooms(const Raster<std::uint32_t>& pieces, std::uint32_t count,
                                          const Raster<std::uint32_t>& rooms) {
    std::vector<std::map<std::uint32_t, std::size_t>> shares(count + std::size_t{1});
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        if (pieces.values[i] != 0) ++shares[pieces.values[i]][rooms.values[i]];
    }
    std::vector<std::uint32_t> result;
    for (const auto& share : shares) {
        const auto most =
            std::max_element(share.begin(), share.end(),
                             [](const auto& p, const auto& q) { return p.second < q.second; });
        result.push_back(most == share.end() ? 0 : most->first);
    }
    return result;
}

/// What is cut anew in pieces, and what is kept as parts of rooms.
struct LocalPieces {
    Raster<std::uint32_t> labels;
    /// Fresh pieces come first, then the kept parts.
    std::uint32_t num_fresh = 0;
    std::vector<KeptPart> kept;
    std::vector<std::uint32_t> earlier_room{0};

    [[nodiscard]] std::uint32_t count() const {
        return num_fresh + static_cast<std::uint32_t>(kept.size());
    }
};

LocalPieces divide(const LocalWindow& window, const Basins& basins) {
    std::vector<std::uint32_t> fresh_number(basins.count + std::size_t{1}, 0);
    for (std::size_t i = 0; i < basins.labels.values.size(); ++i) {
        const std::uint32_t basin = basins.labels.values[i];
        if (basin != 0 && window.decided.contains(basins.labels.cell(i))) fresh_number[basin] = 1;
    }
    const std::vector<std::uint32_t> majority =
        majority_rooms(basins.labels, basins.count, window.rooms);
    LocalPieces pieces;
    for (std::uint32_t basin = 1; basin <= basins.count; ++basin) {
        if (fresh_number[basin] == 0) continue;
        fresh_number[basin] = ++pieces.num_fresh;
        pieces.earlier_room.push_back(majority[basin]);
    }
    // What is kept has its own room, and furniture that was none the room around it.
    Raster<std::uint32_t> kept_room(basins.labels.origin, basins.labels.width,
                                    basins.labels.height);
    for (std::size_t i = 0; i < kept_room.values.size(); ++i) {
        const std::uint32_t basin = basins.labels.values[i];
        if (basin == 0 || fresh_number[basin] != 0) continue;
        if (window.locked.count(window.rooms.values[i]) != 0) continue;
        kept_room.values[i] =
            window.rooms.values[i] != 0 ? window.rooms.values[i] : majority[basin];
    }
    const ConnectedParts parts = connected_parts(
        kept_room, [&](std::size_t i) { return kept_room.values[i] != 0; },
        [&](std::size_t i, std::size_t j) { return kept_room.values[i] == kept_room.values[j]; });
    pieces.labels = parts.labels;
    for (std::size_t i = 0; i < pieces.labels.values.size(); ++i) {
        std::uint32_t& label = pieces.labels.values[i];
        if (label == 0) {
            label = fresh_number[basins.labels.values[i]];
            continue;
        }
        if (label > pieces.kept.size()) {
            pieces.kept.push_back({kept_room.values[i], pieces.labels.cell(i)});
            pieces.earlier_room.push_back(kept_room.values[i]);
        }
        label += pieces.num_fresh;
    }
    return pieces;
}

/// Joins what was one room before and what is not to be decided again: parts that are connected
/// beyond the window, pieces that meet outside of `decided`, and those that people made one.
/// Returns which pieces go on beyond the window.
std::vector<bool> join_what_was_one(const LocalWindow& window, const LocalPieces& pieces,
                                    const AskBeyond& ask_beyond, RegionGraph& regions) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts_of_room;
    for (std::uint32_t k = 0; k < pieces.kept.size(); ++k) {
        parts_of_room[pieces.kept[k].room].push_back(k);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<bool> goes_on(pieces.count() + std::size_t{1}, false);
    for (const auto& [room, parts] : parts_of_room) {
        std::vector<Cell> cells;
        for (const std::uint32_t k : parts) cells.push_back(pieces.kept[k].cell);
        const BeyondWindow beyond = ask_beyond(room, cells, pieces.labels);
        std::vector<std::uint32_t> first_of_group(beyond.groups.size(), 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::uint32_t piece = pieces.num_fresh + 1 + parts[i];
            const std::size_t group = beyond.group_of_part[i];
            goes_on[piece] = beyond.groups[group].area_m2 > 0.0;
            if (first_of_group[group] == 0) {
                first_of_group[group] = piece;
                const Beyond& out = beyond.groups[group];
                regions.add_beyond(piece, out.area_m2, out.peak_m, out.num_openings);
            } else {
                pairs.emplace_back(first_of_group[group], piece);
            }
        }
    }
    const auto meet = [&](std::size_t i, std::size_t j) {
        const std::uint32_t a = pieces.labels.values[i];
        const std::uint32_t b = pieces.labels.values[j];
        if (a == b || a == 0 || b == 0 || pieces.earlier_room[a] != pieces.earlier_room[b]) return;
        const std::uint32_t room = pieces.earlier_room[a];
        if (room == 0) return;
        if (window.decided.contains(pieces.labels.cell(i)) && window.merged.count(room) == 0)
            return;
        pairs.emplace_back(std::max(a, b), std::min(a, b));
    };
    const auto width = static_cast<std::size_t>(pieces.labels.width);
    for (std::size_t i = 0; i < pieces.labels.values.size(); ++i) {
        if ((i + 1) % width != 0) meet(i, i + 1);
        if (i + width < pieces.labels.values.size()) meet(i, i + width);
    }
    for (const auto& [p, q] : pairs) {
        const std::uint32_t a = regions.region_of(p);
        const std::uint32_t b = regions.region_of(q);
        if (a != b) regions.join(a, b);
    }
    return goes_on;
}

}  // namespace

LocalCut cut_locally(const LocalWindow& window, const SegmentOptions& options,
                     const AskBeyond& beyond, const Executor& executor) {
    const double resolution_m = window.resolution_m;
    const Raster<std::uint8_t> kept = cells_to_cut(window, options.rooms.min_component_m2);
    const Raster<std::uint8_t> open = open_space(kept, resolution_m, options.rooms.max_furniture_m2,
                                                 options.rooms.furniture, executor);
    const Raster<float> clearance = clearance_m(open, resolution_m, executor);
    LocalPieces pieces = divide(window, build_basins(clearance, resolution_m, executor));
    RegionGraph regions(pieces.labels, pieces.count(), clearance, resolution_m);
    LocalCut cut;
    cut.num_nodes = pieces.count();
    const Window limits{window.decided, join_what_was_one(window, pieces, beyond, regions)};
    Raster<std::uint8_t> free(kept.origin, kept.width, kept.height);
    for (std::size_t i = 0; i < free.values.size(); ++i) {
        free.values[i] = window.states.values[i] == CellState::free ? 1 : 0;
    }
    cut.regions = fuse_into_rooms({pieces.labels, clearance, free, resolution_m}, options.rooms,
                                  limits, executor, regions);

    std::vector<std::uint32_t> number(pieces.count() + std::size_t{1}, 0);
    cut.peak_m = {0.0};
    for (std::uint32_t& label : cut.regions.values) {
        if (label == 0) continue;
        if (number[label] == 0) {
            number[label] = ++cut.num_regions;
            cut.peak_m.push_back(regions.peak_m(label));
        }
        label = number[label];
    }
    for (std::size_t i = 0; i < cut.regions.values.size() && !window.locked.empty(); ++i) {
        if (window.locked.count(window.rooms.values[i]) != 0) cut.regions.values[i] = kNotCut;
    }
    cut.kept = pieces.kept;
    for (const KeptPart& part : cut.kept) {
        cut.region_of_kept.push_back(cut.regions.at(part.cell));
    }
    for (std::uint32_t region = 1; region <= regions.num_pieces(); ++region) {
        for (const auto& [other, saddle] : regions.saddles(region)) {
            if (region < other && window.decided.contains(saddle.a)) {
                cut.openings.push_back({saddle.a, saddle.b, saddle.clearance_m, 0, 0});
            }
        }
    }
    return cut;
}

}  // namespace quadcut
