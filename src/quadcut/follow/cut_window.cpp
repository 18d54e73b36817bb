// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/cut_window.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "quadcut/follow/beyond.hpp"
#include "quadcut/follow/part_rooms.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/rooms/glimpses.hpp"
#include "quadcut/rooms/rooms.hpp"

namespace quadcut {
namespace {

/// The connected free cells that are large enough, that have been a room, or that may go on beyond
/// the window.
Raster<std::uint8_t> cells_to_cut(const Raster<CellState>& states, double cell_m2,
                                  double min_component_m2) {
    const ConnectedParts parts = connected_parts(
        states, [&](std::size_t i) { return states.values[i] == CellState::free ? 1U : 0U; });
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
/// Returns how many cells were looked at.
std::size_t add_beyond(const FollowedMap& followed, const Window& window,
                       const Raster<std::uint32_t>& pieces, RegionGraph& regions) {
    const std::vector<std::uint32_t> room_of =
        majority_rooms(pieces, regions.num_pieces(), window.rooms);
    std::map<std::uint32_t, std::vector<Cell>> on_edge;
    std::vector<bool> seen(regions.num_pieces() + std::size_t{1}, false);
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        const std::uint32_t piece = pieces.values[i];
        if (piece == 0 || seen[piece] || !is_on_edge(pieces, i)) continue;
        const std::uint32_t room = room_of[piece];
        if (room == 0 || window.rooms.values[i] != room) continue;
        seen[piece] = true;
        on_edge[room].push_back(pieces.cell(i));
    }
    std::size_t cells_read = 0;
    for (const auto& [room, cells] : on_edge) {
        const Outside outside = look_outside(followed, window, room, cells, pieces);
        cells_read += outside.cells_read;
        const std::vector<Beyond> beyond = beyond_of(followed, window.states.box(), room, outside);
        // All groups first: what was joined gets no more.
        std::map<std::size_t, std::uint32_t> first;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const std::size_t group = outside.group_of_part[k];
            const bool is_new = first.emplace(group, pieces.at(cells[k])).second;
            if (is_new) regions.add_beyond(pieces.at(cells[k]), beyond[group]);
        }
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const std::uint32_t a = regions.region_of(first.at(outside.group_of_part[k]));
            const std::uint32_t b = regions.region_of(pieces.at(cells[k]));
            if (a != b) regions.join(a, b);
        }
    }
    return cells_read;
}

/// The window cut for itself; in its own cells.
struct Alone {
    RoomsCut cut;
    std::size_t cells_read = 0;
};

Alone cut_alone(const FollowedMap& followed, const Window& window, const SegmentOptions& options,
                const Executor& executor) {
    const double resolution_m = followed.map.resolution_m();
    Layout layout = followed.cells.orientation();
    layout.box = window.states.box();
    const Raster<std::uint8_t> kept =
        cells_to_cut(window.states, followed.cell_m2(), options.rooms.min_component_m2);
    const auto states = laid_out<CellState>(window.states, layout, CellState::unknown);
    Alone alone{{}, window.states.values.size()};
    const auto beyond = [&](const Raster<std::uint32_t>& laid_pieces, RegionGraph& regions) {
        Raster<std::uint32_t> pieces(layout.box);
        put_back(laid_pieces, layout, pieces);
        alone.cells_read += add_beyond(followed, window, pieces, regions);
    };
    StageClock clock;
    RoomsCut laid =
        cut_into_rooms({laid_out<std::uint8_t>(kept, layout, 0), states, resolution_m, beyond},
                       options.rooms, clock, executor);
    std::vector<Cell> way = followed.way;
    for (Cell& cell : way) cell = layout.place_of(cell);
    split_off_fans(laid.rooms, laid.clearance_m, window.states, layout, resolution_m,
                   options.rooms.min_passable_m, options.rooms.min_room_m2, way, executor);
    alone.cut.rooms = Raster<std::uint32_t>(layout.box);
    alone.cut.pieces = Raster<std::uint32_t>(layout.box);
    alone.cut.clearance_m = Raster<float>(layout.box);
    alone.cut.num_pieces = laid.num_pieces;
    put_back(laid.rooms, layout, alone.cut.rooms);
    put_back(laid.pieces, layout, alone.cut.pieces);
    put_back(laid.clearance_m, layout, alone.cut.clearance_m);
    return alone;
}

/// The window in parts that are connected: of new regions where it is decided anew, and of rooms
/// that are kept.
struct Parts {
    Raster<std::uint32_t> labels;
    std::uint32_t count = 0;
    std::vector<bool> is_kept;
    /// The room that most cells of the part had; 0 = none.
    std::vector<std::uint32_t> earlier_room;
};

/// Pieces that reach into what is decided are decided as a whole.
std::vector<std::uint8_t> cells_decided(const Window& window, const RoomsCut& cut) {
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

Parts divide(const Window& window, const RoomsCut& cut,
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
    std::vector<std::uint32_t> numbers(parts.count + std::size_t{1});
    std::iota(numbers.begin(), numbers.end(), 0U);
    Parts result{Raster<std::uint32_t>(window.rooms.box()),
                 parts.count,
                 std::vector<bool>(numbers.size(), false),
                 {}};
    parts.paint(numbers, result.labels);
    for (std::size_t i = 0; i < is_decided.size(); ++i) {
        if (is_decided[i] == 0) result.is_kept[result.labels.values[i]] = true;
    }
    result.is_kept[0] = false;
    result.earlier_room = majority_rooms(result.labels, parts.count, window.rooms);
    return result;
}

/// Joins a new region with the rooms in which it goes on, and what people made one.
void join_across_borders(const FollowedMap& followed, const RoomsCut& cut, const Parts& parts,
                         LabelSets& sets) {
    const std::vector<std::uint32_t> group_of = groups_of(parts.earlier_room, followed);
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
void join_beyond(const FollowedMap& followed, const Window& window, const Parts& parts,
                 WindowCut& cut, LabelSets& sets) {
    std::map<std::uint32_t, std::vector<Cell>> cells_of_room;
    std::vector<bool> seen(parts.count + std::size_t{1}, false);
    for (std::size_t i = 0; i < parts.labels.values.size(); ++i) {
        const std::uint32_t part = parts.labels.values[i];
        if (seen[part] || !parts.is_kept[part]) continue;
        seen[part] = true;
        const std::uint32_t room = parts.earlier_room[part];
        cells_of_room[room].push_back(parts.labels.cell(i));
        cut.kept.push_back({room, parts.labels.cell(i), cells_of_room[room].size() - 1, 0});
    }
    for (const auto& [room, cells] : cells_of_room) {
        cut.outside[room] = look_outside(followed, window, room, cells, parts.labels);
        cut.cells_read += cut.outside[room].cells_read;
    }
    std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> first;
    for (KeptPart& kept : cut.kept) {
        kept.group = cut.outside.at(kept.room).group_of_part[kept.group];
        const std::uint32_t part = parts.labels.at(kept.cell);
        const auto [at, is_new] = first.emplace(std::pair{kept.room, kept.group}, part);
        if (!is_new) sets.join(at->second, part);
    }
}

/// The widest place between each two regions that meet in what is decided.
std::vector<RoomOpening> find_openings(const Window& window, const Raster<float>& clearance,
                                       const Raster<std::uint32_t>& regions) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, RoomOpening> widest;
    for_each_pair(regions, [&](std::size_t i, std::size_t j) {
        const std::uint32_t a = regions.values[i];
        const std::uint32_t b = regions.values[j];
        if (a == b || a == 0 || b == 0 || a == kNotCut || b == kNotCut) return;
        if (!window.decided.contains(regions.cell(i))) return;
        const float width = std::min(clearance.values[i], clearance.values[j]);
        RoomOpening& opening = widest[std::minmax(a, b)];
        if (width > opening.clearance_m) opening = {regions.cell(i), regions.cell(j), width};
    });
    std::vector<RoomOpening> openings;
    for (const auto& [pair, opening] : widest) {
        if (opening.clearance_m > 0.0F) openings.push_back(opening);
    }
    return openings;
}

}  // namespace

WindowCut cut_window(const FollowedMap& followed, const Window& window,
                     const SegmentOptions& options, const Executor& executor) {
    auto [anew, cells_read] = cut_alone(followed, window, options, executor);
    WindowCut cut;
    cut.cells_read = cells_read;
    const std::vector<std::uint8_t> is_decided = cells_decided(window, anew);
    const Parts parts = divide(window, anew, is_decided);
    cut.num_nodes = anew.num_pieces;
    LabelSets sets;
    for (std::uint32_t part = 1; part <= parts.count; ++part) sets.add();
    join_across_borders(followed, anew, parts, sets);
    join_beyond(followed, window, parts, cut, sets);
    const std::vector<std::uint32_t> numbers = sets.take_numbers();
    cut.num_regions = *std::max_element(numbers.begin(), numbers.end());
    cut.peak_m.assign(cut.num_regions + std::size_t{1}, 0.0);
    cut.regions = parts.labels;
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        std::uint32_t& region = cut.regions.values[i];
        const bool is_locked = window.locked.count(window.rooms.values[i]) != 0;
        region = is_locked ? kNotCut : numbers[region];
        if (is_locked) continue;
        cut.peak_m[region] =
            std::max(cut.peak_m[region], static_cast<double>(anew.clearance_m.values[i]));
    }
    for (KeptPart& part : cut.kept) part.region = cut.regions.at(part.cell);
    cut.openings = find_openings(window, anew.clearance_m, cut.regions);
    // What was taken for a wall and is none has clearance, too.
    const bool is_all_cut = window.locked.empty() && followed.split_lines.empty();
    if (is_all_cut) cut.all_cut = anew.clearance_m.box();
    return cut;
}

}  // namespace quadcut
