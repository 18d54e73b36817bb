// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quadcut/route/bends.hpp"
#include "quadcut/route/route_planner.hpp"

namespace quadcut {

/// One search of a RoutePlanner: A* over the crossings of rooms, whose lengths within a room are
/// known, from and to the nodes that the two ends see.
class RouteSearch {
public:
    explicit RouteSearch(RoutePlanner& planner) : planner_(planner), sight_(planner.floor_) {}
    [[nodiscard]] std::optional<Route> find(Cell from, Cell to);

private:
    /// A node that an end of the way sees.
    struct Seen {
        std::uint32_t node = 0;
        float length = 0.0F;
    };
    /// An end of the way: its room, a hub that it sees there (all nodes, where it sees none), and
    /// for each crossing of the room the length of the way there and which of these is on it.
    struct End {
        Cell cell;
        std::size_t room = 0;
        std::vector<Seen> seen;
        std::vector<Seen> to_crossing;
    };
    /// A crossing as it is left: from which room, which of its crossings.
    struct Exit {
        std::size_t room = 0;
        std::uint32_t crossing = 0;
    };

    [[nodiscard]] End look_around(Cell cell);
    [[nodiscard]] std::vector<Seen> seen_from(Cell cell, std::size_t room);
    /// The way within the room of both ends; empty if there is none.
    [[nodiscard]] std::vector<Bend> way_within(const End& from, const End& to);
    /// The exits on the shortest way that is shorter than `limit` cells; empty if there is none.
    [[nodiscard]] std::vector<Exit> find_exits(const End& from, const End& to, float limit);
    [[nodiscard]] std::vector<Bend> bends_of(const std::vector<Exit>& exits, const End& from,
                                             const End& to);
    /// Where there is a hub at a place of the way: goes round a corner instead that it sees, if
    /// that is shorter.
    void round_corner(std::vector<Bend>& way, std::size_t place, const RoomGraph& graph);
    [[nodiscard]] Route route_of(const std::vector<Bend>& way);
    void note_steps(Cell from, Cell to, Route& route);
    void note_step(std::uint16_t label, std::uint16_t next, Cell cell, Route& route) const;

    RoutePlanner& planner_;
    Sight sight_;
    std::size_t num_entries_ = 0;
};

}  // namespace quadcut
