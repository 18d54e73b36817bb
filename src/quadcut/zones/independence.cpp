// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/independence.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace quadcut {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

double distance_to(const Door& door, const Point& at) {
    const Point way{door.jamb_2.x - door.jamb_1.x, door.jamb_2.y - door.jamb_1.y};
    const Point from{at.x - door.jamb_1.x, at.y - door.jamb_1.y};
    const double squared = way.x * way.x + way.y * way.y;
    const double t = squared > 0.0 ? (from.x * way.x + from.y * way.y) / squared : 0.0;
    return distance(from, {std::clamp(t, 0.0, 1.0) * way.x, std::clamp(t, 0.0, 1.0) * way.y});
}

std::map<Pair, std::vector<Door>> doors_between(const Segmentation& rooms,
                                                std::span<const std::uint32_t> part_of_room) {
    std::map<RoomId, std::uint32_t> part_of;
    for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
        part_of[rooms.rooms[i].id] = part_of_room[i];
    }
    std::map<Pair, std::vector<Door>> doors;
    for (const Door& door : rooms.doors) {
        const Pair pair = std::minmax(part_of.at(door.a), part_of.at(door.b));
        if (pair.first != pair.second) doors[pair].push_back(door);
    }
    return doors;
}

struct Counts {
    /// Scans that see a part.
    std::map<std::uint32_t, std::size_t> of_part;
    /// Scans that see both of two.
    std::map<Pair, std::size_t> of_pair;
    /// Of the scans at a door of a pair.
    std::map<Pair, SharedScans> at_doors;
};

void count_seen(const std::set<std::uint32_t>& seen, Counts& counts) {
    for (auto a = seen.begin(); a != seen.end(); ++a) {
        ++counts.of_part[*a];
        for (auto b = std::next(a); b != seen.end(); ++b) ++counts.of_pair[{*a, *b}];
    }
}

void count_at_doors(const std::set<std::uint32_t>& seen, const Point& at,
                    const std::map<Pair, std::vector<Door>>& doors, Counts& counts) {
    for (const auto& [pair, between] : doors) {
        const bool sees_a = seen.contains(pair.first);
        const bool sees_b = seen.contains(pair.second);
        if (!sees_a && !sees_b) continue;
        if (std::none_of(between.begin(), between.end(),
                         [&](const Door& door) { return distance_to(door, at) <= kAtDoorM; })) {
            continue;
        }
        SharedScans& shared = counts.at_doors[pair];
        ++shared.either;
        if (sees_a && sees_b) ++shared.both;
    }
}

/// Cells that scans saw, and those of them in another part than the one they stood in.
struct Outside {
    std::size_t num_scans = 0;
    std::size_t seen = 0;
    std::size_t outside = 0;

    void add(const Sighting& sighting, std::span<const std::uint32_t> part_of_room) {
        if (sighting.own == 0) return;
        const std::uint32_t own = part_of_room[sighting.own - std::size_t{1}];
        ++num_scans;
        for (const SeenFloor& floor : sighting.floors) {
            seen += floor.num_cells;
            if (part_of_room[floor.room - std::size_t{1}] != own) outside += floor.num_cells;
        }
    }
};

std::vector<PairIndependence> pairs_of(const Counts& counts,
                                       const std::map<Pair, std::vector<Door>>& doors) {
    std::map<Pair, PairIndependence> known;
    for (const auto& [pair, both] : counts.of_pair) known[pair].all.both = both;
    for (const auto& [pair, between] : doors) known[pair].num_doors = between.size();
    const auto num_seeing = [&](std::uint32_t part) {
        const auto at = counts.of_part.find(part);
        return at == counts.of_part.end() ? 0 : at->second;
    };
    std::vector<PairIndependence> pairs;
    for (auto& [parts, pair] : known) {
        pair.a = parts.first;
        pair.b = parts.second;
        pair.all.either = num_seeing(pair.a) + num_seeing(pair.b) - pair.all.both;
        pair.given_doors = pair.all;
        if (const auto at = counts.at_doors.find(parts); at != counts.at_doors.end()) {
            pair.given_doors.either -= at->second.either;
            pair.given_doors.both -= at->second.both;
        }
        pairs.push_back(pair);
    }
    return pairs;
}

}  // namespace

std::size_t num_independent(std::span<const PairIndependence> pairs,
                            SharedScans PairIndependence::*of) {
    return static_cast<std::size_t>(std::count_if(
        pairs.begin(), pairs.end(),
        [of](const PairIndependence& pair) { return (pair.*of).share() < kIndependentShare; }));
}

Independence independence_of_zones(std::span<const Sighting> sightings, const GridMap& map,
                                   const Segmentation& rooms,
                                   std::span<const std::uint32_t> zone_of_room) {
    const std::map<Pair, std::vector<Door>> doors = doors_between(rooms, zone_of_room);
    Counts counts;
    Outside outside;
    for (const Sighting& sighting : sightings) {
        std::set<std::uint32_t> seen;
        for (const std::uint32_t label : labels_seen(sighting, map, rooms)) {
            seen.insert(zone_of_room[label - std::size_t{1}]);
        }
        count_seen(seen, counts);
        count_at_doors(seen, sighting.at, doors, counts);
        outside.add(sighting, zone_of_room);
    }
    Independence result;
    result.num_parts = std::set(zone_of_room.begin(), zone_of_room.end()).size();
    result.num_scans = outside.num_scans;
    result.seen_outside = outside.seen == 0 ? 0.0
                                            : static_cast<double>(outside.outside) /
                                                  static_cast<double>(outside.seen);
    result.pairs = pairs_of(counts, doors);
    return result;
}

Independence independence_of_rooms(std::span<const Sighting> sightings, const GridMap& map,
                                   const Segmentation& rooms) {
    std::vector<std::uint32_t> ids;
    for (const Room& room : rooms.rooms) ids.push_back(static_cast<std::uint32_t>(room.id));
    return independence_of_zones(sightings, map, rooms, ids);
}

IndependenceReport independence_of(std::span<const Sighting> sightings, const GridMap& map,
                                   const Segmentation& rooms) {
    return {independence_of_zones(sightings, map, rooms, rooms.zones.zone_of_room),
            independence_of_rooms(sightings, map, rooms)};
}

}  // namespace quadcut
