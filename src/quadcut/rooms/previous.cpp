// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/previous.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/map/flood.hpp"

namespace quadcut {
namespace {

/// In log-odds: the evidence that it takes to cut what was one room, and to join what was two: the
/// latter is less, since a wall that has gone is seen at the opening alone.
constexpr double kKeepsTogether = 13.0;
constexpr double kKeepsApart = 6.0;
/// A border in one room of which so little is open still is a wall; so much is no change.
constexpr double kWall = 0.3;
constexpr double kOpen = 0.55;
/// A room, or a whole result, of which less is free now is not of this place.
constexpr double kStillFree = 0.75;

/// The pieces in which rooms met.
std::vector<bool> mixed_pieces(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                               const Raster<std::uint16_t>& earlier) {
    std::vector<std::uint16_t> room(num_pieces + std::size_t{1}, 0);
    std::vector<bool> is_mixed(room.size(), false);
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        const std::uint32_t piece = pieces.values[i];
        if (piece == 0 || earlier.values[i] == 0) continue;
        if (room[piece] == 0) room[piece] = earlier.values[i];
        if (room[piece] != earlier.values[i]) is_mixed[piece] = true;
    }
    return is_mixed;
}

/// Looks along rows or columns for what was a room's floor and is none now, between two pieces.
class NewWalls {
public:
    NewWalls(const Raster<std::uint32_t>& pieces, const Raster<std::uint16_t>& earlier)
        : pieces_(pieces), earlier_(earlier) {}

    void look_along(std::size_t first, std::size_t step, std::size_t count) {
        std::uint32_t last = 0;
        bool is_wall = false;
        for (std::size_t k = 0, i = first; k < count; ++k, i += step) {
            const std::uint32_t piece = pieces_.values[i];
            if (piece != 0) {
                if (is_wall && last != 0 && last != piece) ++num_lines_[std::minmax(last, piece)];
                last = piece;
            } else if (earlier_.values[i] == 0) {
                last = 0;
            }
            is_wall = piece == 0;
        }
    }
    [[nodiscard]] const std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>& num_lines()
        const {
        return num_lines_;
    }

private:
    const Raster<std::uint32_t>& pieces_;
    const Raster<std::uint16_t>& earlier_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> num_lines_;
};

}  // namespace

Raster<std::uint16_t> rooms_still_there(Raster<std::uint16_t> earlier,
                                        const Raster<CellState>& states) {
    struct Count {
        std::size_t num_cells = 0;
        std::size_t num_free = 0;
        [[nodiscard]] bool is_there() const {
            return static_cast<double>(num_free) >= kStillFree * static_cast<double>(num_cells);
        }
    };
    Count all;
    std::map<std::uint16_t, Count> rooms;
    for (std::size_t i = 0; i < earlier.values.size(); ++i) {
        if (earlier.values[i] == 0) continue;
        for (Count* count : {&all, &rooms[earlier.values[i]]}) {
            ++count->num_cells;
            if (states.values[i] == CellState::free) ++count->num_free;
        }
    }
    if (!all.is_there()) return {};
    for (std::uint16_t& room : earlier.values) {
        if (room != 0 && !rooms.at(room).is_there()) room = 0;
    }
    return earlier;
}

std::uint32_t cut_where_rooms_met(Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                                  const Raster<std::uint16_t>& earlier) {
    const std::vector<bool> is_mixed = mixed_pieces(pieces, num_pieces, earlier);
    // Outward from what was known, in all mixed pieces at once.
    std::vector<std::size_t> front;
    std::map<std::size_t, std::uint16_t> room_of_cell;
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        if (!is_mixed[pieces.values[i]] || earlier.values[i] == 0) continue;
        front.push_back(i);
        room_of_cell[i] = earlier.values[i];
    }
    for (std::size_t at = 0; at < front.size(); ++at) {
        const std::size_t cell = front[at];
        for (const std::size_t next : Neighbours(pieces, cell, Connectivity::four)) {
            if (pieces.values[next] != pieces.values[cell]) continue;
            if (room_of_cell.emplace(next, room_of_cell.at(cell)).second) front.push_back(next);
        }
    }
    std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t> number;
    std::vector<bool> is_used(num_pieces + std::size_t{1}, false);
    for (const auto& [cell, room] : room_of_cell) {
        const std::uint32_t piece = pieces.values[cell];
        const auto [part, is_new] = number.try_emplace({piece, room}, piece);
        if (is_new && is_used[piece]) part->second = ++num_pieces;
        if (is_new) is_used[piece] = true;
        pieces.values[cell] = part->second;
    }
    return num_pieces;
}

EarlierDecisions::EarlierDecisions(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                                   const Raster<std::uint16_t>& earlier)
    : pieces_(num_pieces + std::size_t{1}) {
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        Before& piece = pieces_[pieces.values[i]];
        ++piece.num_cells;
        if (earlier.values[i] == 0) continue;
        piece.room = earlier.values[i];
        ++piece.num_known;
    }
    NewWalls walls(pieces, earlier);
    const auto width = static_cast<std::size_t>(pieces.width);
    const auto height = static_cast<std::size_t>(pieces.height);
    for (std::size_t y = 0; y < height; ++y) walls.look_along(y * width, 1, width);
    for (std::size_t x = 0; x < width; ++x) walls.look_along(x, width, height);
    for (const auto& [pair, num_lines] : walls.num_lines()) {
        new_walls_.push_back({pair.first, pair.second, num_lines});
    }
}

/// Whether the border between two regions that were one room is open still: 0 no, 1 yes.
double EarlierDecisions::openness(const RegionGraph& regions, std::uint32_t a,
                                  std::uint32_t b) const {
    const auto num_open = static_cast<double>(regions.saddles(a).at(b).num_contacts);
    double num_closed = 0.0;
    for (const NewWall& wall : new_walls_) {
        const std::uint32_t p = regions.region_of(wall.a);
        const std::uint32_t q = regions.region_of(wall.b);
        const bool is_between = (p == a && q == b) || (p == b && q == a);
        if (is_between) num_closed += static_cast<double>(wall.num_lines);
    }
    // Of slits alone nothing counts.
    const double share = num_open / std::max(1.0, num_open + num_closed);
    return std::clamp((share - kWall) / (kOpen - kWall), 0.0, 1.0);
}

const EarlierDecisions::Before& EarlierDecisions::before(const RegionGraph& regions,
                                                         std::uint32_t region) {
    const auto [at, is_new] = regions_.try_emplace(region);
    auto& [version, before] = at->second;
    if (!is_new && version == regions.version(region)) return before;
    version = regions.version(region);
    std::map<std::uint16_t, std::size_t> num_cells;
    before = {};
    for (const std::uint32_t member : regions.members(region)) {
        const Before& piece = pieces_[member];
        before.num_cells += piece.num_cells;
        num_cells[piece.room] += piece.num_known;
    }
    for (const auto& [room, count] : num_cells) {
        if (room == 0 || count <= before.num_known) continue;
        before.room = room;
        before.num_known = count;
    }
    return before;
}

double EarlierDecisions::log_odds(const RegionGraph& regions, std::uint32_t a, std::uint32_t b) {
    if (is_empty()) return 0.0;
    const auto known_share = [](const Before& before) {
        return static_cast<double>(before.num_known) / static_cast<double>(before.num_cells);
    };
    const Before was_a = before(regions, a);
    const Before was_b = before(regions, b);
    if (was_a.room == 0 || was_b.room == 0) return 0.0;
    const double known = std::min(known_share(was_a), known_share(was_b));
    if (was_a.room != was_b.room) return kKeepsApart * known;
    return is_for_cuts_ ? 0.0 : -kKeepsTogether * known * openness(regions, a, b);
}

EarlierDecisions EarlierDecisions::for_cuts_only() const {
    EarlierDecisions decisions = *this;
    decisions.is_for_cuts_ = true;
    return decisions;
}

}  // namespace quadcut
