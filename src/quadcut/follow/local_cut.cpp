// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/local_cut.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "quadcut/follow/part_rooms.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/rooms/rooms.hpp"

namespace quadcut {
namespace {

/// The connected free cells that are large enough, that have been a room, or that may go on beyond
/// the window.
Raster<std::uint8_t> cells_to_cut(const LocalWindow& window, double min_component_m2) {
    const Raster<CellState>& states = window.states;
    const ConnectedParts parts = connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free ? 1U : 0U; });
    const double cell_m2 = window.resolution_m * window.resolution_m;
    std::vector<bool> is_kept = parts.on_edge();
    const std::vector<std::size_t> num_cells = parts.num_cells();
    for (std::uint32_t part = 1; part <= parts.count; ++part) {
        if (static_cast<double>(num_cells[part]) * cell_m2 >= min_component_m2)
            is_kept[part] = true;
    }
    Raster<std::uint8_t> kept(states.origin, states.width, states.height);
    parts.paint(is_kept, kept);
    return kept;
}

/// What the pieces on the edge have beyond it; those that are connected there are one region.
void add_beyond(const LocalWindow& window, const Raster<std::uint32_t>& pieces,
                const AskBeyond& ask_beyond, RegionGraph& regions) {
    const std::vector<std::uint32_t> room_of =
        majority_rooms(pieces, regions.num_pieces(), window.rooms);
    struct OnEdge {
        std::vector<std::uint32_t> pieces;
        std::vector<Cell> cells;
    };
    std::map<std::uint32_t, OnEdge> rooms;
    std::vector<bool> seen(regions.num_pieces() + std::size_t{1}, false);
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        const std::uint32_t piece = pieces.values[i];
        if (piece == 0 || seen[piece] || !is_on_edge(pieces, i)) continue;
        const std::uint32_t room = room_of[piece];
        if (room == 0 || window.rooms.values[i] != room) continue;
        seen[piece] = true;
        rooms[room].pieces.push_back(piece);
        rooms[room].cells.push_back(pieces.cell(i));
    }
    for (const auto& [room, on_edge] : rooms) {
        const BeyondWindow beyond = ask_beyond(room, on_edge.cells, pieces);
        std::map<std::size_t, std::uint32_t> first;
        for (std::size_t k = 0; k < on_edge.pieces.size(); ++k) {
            const std::size_t group = beyond.group_of_part[k];
            if (first.emplace(group, on_edge.pieces[k]).second) {
                regions.add_beyond(on_edge.pieces[k], beyond.groups[group]);
            }
        }
        for (std::size_t k = 0; k < on_edge.pieces.size(); ++k) {
            const std::uint32_t a = regions.region_of(first.at(beyond.group_of_part[k]));
            const std::uint32_t b = regions.region_of(on_edge.pieces[k]);
            if (a != b) regions.join(a, b);
        }
    }
}

/// The window cut for itself; in its own cells.
RoomsCut cut_window(const LocalWindow& window, const SegmentOptions& options,
                    const AskBeyond& ask_beyond, const Executor& executor) {
    Layout layout = window.orientation;
    layout.box = window.states.box();
    auto kept =
        laid_out<std::uint8_t>(cells_to_cut(window, options.rooms.min_component_m2), layout, 0);
    Raster<std::uint8_t> free(window.states.origin, window.states.width, window.states.height);
    for (std::size_t i = 0; i < free.values.size(); ++i) {
        free.values[i] = window.states.values[i] == CellState::free ? 1 : 0;
    }
    StageClock clock;
    const auto free_laid = laid_out<std::uint8_t>(free, layout, 0);
    const auto beyond = [&](const Raster<std::uint32_t>& laid_pieces, RegionGraph& regions) {
        Raster<std::uint32_t> pieces(layout.box);
        put_back(laid_pieces, layout, pieces);
        add_beyond(window, pieces, ask_beyond, regions);
    };
    const RoomsCut laid = cut_into_rooms({std::move(kept), free_laid, window.resolution_m, beyond},
                                         options.rooms, clock, executor);
    RoomsCut cut{Raster<std::uint32_t>(layout.box),
                 Raster<std::uint32_t>(layout.box),
                 laid.num_pieces,
                 Raster<float>(layout.box),
                 {}};
    put_back(laid.rooms, layout, cut.rooms);
    put_back(laid.pieces, layout, cut.pieces);
    put_back(laid.clearance_m, layout, cut.clearance_m);
    return cut;
}

/// The window in parts that are connected: of new regions where it is decided anew, and of rooms
/// that are kept.
struct Parts {
    Raster<std::uint32_t> labels;
    std::uint32_t count = 0;
    std::vector<bool> is_kept{false};
    /// The room that most cells of the part had; 0 = none.
    std::vector<std::uint32_t> earlier_room{0};
};

/// Pieces that reach into what is decided are decided as a whole.
std::vector<std::uint8_t> cells_decided(const LocalWindow& window, const RoomsCut& cut) {
    std::vector<bool> is_decided(cut.num_pieces + std::size_t{1}, false);
    for (std::size_t i = 0; i < cut.pieces.values.size(); ++i) {
        if (window.decided.contains(cut.pieces.cell(i))) is_decided[cut.pieces.values[i]] = true;
    }
    std::vector<std::uint8_t> result(cut.pieces.values.size(), 0);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::uint32_t piece = cut.pieces.values[i];
        result[i] =
            (piece != 0 ? is_decided[piece] : window.decided.contains(cut.pieces.cell(i))) ? 1 : 0;
    }
    return result;
}

Parts divide(const LocalWindow& window, const RoomsCut& cut,
             const std::vector<std::uint8_t>& is_decided) {
    // What a cell belongs to: a new region, or a room that is kept.
    const auto owner = [&](std::size_t i) {
        if (is_decided[i] != 0) return cut.rooms.values[i];
        const std::uint32_t room = window.rooms.values[i];
        return window.locked.count(room) != 0 ? 0 : room;
    };
    const ConnectedParts parts = connected_parts(window.rooms, [&](std::size_t i) {
        const std::uint64_t own = owner(i);
        return own != 0 ? 2 * own + is_decided[i] : 0;
    });
    Raster<std::uint32_t> labels(window.rooms.origin, window.rooms.width, window.rooms.height);
    std::vector<std::uint32_t> numbers(parts.count + std::size_t{1});
    std::iota(numbers.begin(), numbers.end(), 0U);
    parts.paint(numbers, labels);
    Parts result{std::move(labels), parts.count, {}, {}};
    result.is_kept.assign(parts.count + std::size_t{1}, false);
    for (std::size_t i = 0; i < is_decided.size(); ++i) {
        if (is_decided[i] == 0) result.is_kept[result.labels.values[i]] = true;
    }
    result.is_kept[0] = false;
    result.earlier_room = majority_rooms(result.labels, parts.count, window.rooms);
    return result;
}

/// Joins a new region with the rooms in which it goes on, and what people made one.
void join_across_borders(const LocalWindow& window, const RoomsCut& cut, const Parts& parts,
                         LabelSets& sets) {
    const std::vector<std::uint32_t> group_of = groups_of(parts.earlier_room, window.merge_groups);
    for_each_pair(parts.labels, [&](std::size_t i, std::size_t j) {
        const std::uint32_t a = parts.labels.values[i];
        const std::uint32_t b = parts.labels.values[j];
        if (a == b || a == 0 || b == 0) return;
        const bool goes_on = parts.is_kept[a] != parts.is_kept[b] && cut.rooms.values[i] != 0 &&
                             cut.rooms.values[i] == cut.rooms.values[j];
        const bool is_one = group_of[a] != 0 && group_of[a] == group_of[b];
        if (goes_on || is_one) sets.join(a, b);
    });
}

/// Joins kept parts that are connected outside of the window.
void join_beyond(const Parts& parts, const AskBeyond& ask_beyond, LocalCut& cut, LabelSets& sets) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts_of_room;
    std::vector<bool> seen(parts.count + std::size_t{1}, false);
    for (std::size_t i = 0; i < parts.labels.values.size(); ++i) {
        const std::uint32_t part = parts.labels.values[i];
        if (seen[part] || !parts.is_kept[part]) continue;
        seen[part] = true;
        parts_of_room[parts.earlier_room[part]].push_back(part);
        cut.kept.push_back({parts.earlier_room[part], parts.labels.cell(i)});
    }
    std::map<std::uint32_t, std::vector<Cell>> cells_of_room;
    for (const KeptPart& kept : cut.kept) cells_of_room[kept.room].push_back(kept.cell);
    for (const auto& [room, of_room] : parts_of_room) {
        const std::vector<std::size_t> groups =
            ask_beyond(room, cells_of_room[room], parts.labels).group_of_part;
        std::map<std::size_t, std::uint32_t> first;
        for (std::size_t k = 0; k < of_room.size(); ++k) {
            const auto [at, is_new] = first.emplace(groups[k], of_room[k]);
            if (!is_new) sets.join(at->second, of_room[k]);
        }
    }
}

/// The widest place between each two regions that meet in what is decided.
std::vector<LocalOpening> find_openings(const LocalWindow& window, const Raster<float>& clearance,
                                        const Raster<std::uint32_t>& regions) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, LocalOpening> widest;
    for_each_pair(regions, [&](std::size_t i, std::size_t j) {
        const std::uint32_t a = regions.values[i];
        const std::uint32_t b = regions.values[j];
        if (a == b || a == 0 || b == 0 || a == kNotCut || b == kNotCut) return;
        if (!window.decided.contains(regions.cell(i))) return;
        const float width = std::min(clearance.values[i], clearance.values[j]);
        LocalOpening& opening = widest[std::minmax(a, b)];
        if (width > opening.clearance_m) opening = {regions.cell(i), regions.cell(j), width, 0, 0};
    });
    std::vector<LocalOpening> openings;
    for (const auto& [pair, opening] : widest) {
        if (opening.clearance_m > 0.0F) openings.push_back(opening);
    }
    return openings;
}

}  // namespace

LocalCut cut_locally(const LocalWindow& window, const SegmentOptions& options,
                     const AskBeyond& ask_beyond, const Executor& executor) {
    const RoomsCut anew = cut_window(window, options, ask_beyond, executor);
    const std::vector<std::uint8_t> is_decided = cells_decided(window, anew);
    const Parts parts = divide(window, anew, is_decided);
    LocalCut cut;
    cut.num_nodes = anew.num_pieces;
    LabelSets sets;
    for (std::uint32_t part = 1; part <= parts.count; ++part) sets.add();
    join_across_borders(window, anew, parts, sets);
    join_beyond(parts, ask_beyond, cut, sets);
    const std::vector<std::uint32_t> numbers = sets.take_numbers();
    cut.num_regions = *std::max_element(numbers.begin(), numbers.end());
    cut.regions = parts.labels;
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        std::uint32_t& region = cut.regions.values[i];
        region = window.locked.count(window.rooms.values[i]) != 0 ? kNotCut : numbers[region];
    }
    for (const KeptPart& part : cut.kept) {
        cut.region_of_kept.push_back(cut.regions.at(part.cell));
    }
    cut.peak_m.assign(cut.num_regions + std::size_t{1}, 0.0);
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        const std::uint32_t region = cut.regions.values[i];
        if (region == kNotCut) continue;
        cut.peak_m[region] =
            std::max(cut.peak_m[region], static_cast<double>(anew.clearance_m.values[i]));
    }
    cut.openings = find_openings(window, anew.clearance_m, cut.regions);
    return cut;
}

}  // namespace quadcut
