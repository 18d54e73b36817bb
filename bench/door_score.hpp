// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "bench/building_case.hpp"
#include "io/label_image.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/segment/result.hpp"
#include "sim/building.hpp"

// Found doors against the true ones of a simulated building.
namespace quadcut {

/// The middles of two doors that are one are no farther apart.
inline constexpr double kSameDoorM = 0.3;
/// A door so far from where it should be is one that lies wrong, not another one.
inline constexpr double kDisplacedDoorM = 1.0;

struct DoorPair {
    std::size_t predicted = 0;
    std::size_t truth = 0;
    double distance_m = 0.0;
};

/// A true opening without a match (missed), or a found one without (extra), and why.
struct DoorError {
    std::string cause;
    Point at;
    double width_m = 0.0;
    bool is_open_passage = false;
    /// What is on its two sides in truth.
    std::string rooms;
};

struct DoorScore {
    std::vector<DoorPair> pairs;
    std::vector<DoorError> missed;
    std::vector<DoorError> extra;
    /// True openings that do not count because the map does not show both sides of them.
    std::size_t num_unseen = 0;
};

inline Point middle_of(const Point& p, const Point& q) {
    return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
}

/// The labels on the two sides of an opening.
class Beside {
public:
    explicit Beside(const GridMap& map) : map_(map), image_from_map_(inverse(map.map_from_image)) {}

    /// The commonest label within 0.8 m of an opening on one side of it, 0 = none; `side` 1 or -1.
    template <typename Label>
    [[nodiscard]] std::uint32_t label(const Raster<Label>& labels, const Point& jamb_1,
                                      const Point& jamb_2, double side) const {
        const double width_m = std::max(distance(jamb_1, jamb_2), 1e-6);
        const Point along{(jamb_2.x - jamb_1.x) / width_m, (jamb_2.y - jamb_1.y) / width_m};
        const Point middle = middle_of(jamb_1, jamb_2);
        std::map<std::uint32_t, int> votes;
        for (double away = 0.2; away < 0.81; away += 0.05) {
            for (const double share : {-0.25, 0.0, 0.25}) {
                const Point at{middle.x - side * away * along.y + share * width_m * along.x,
                               middle.y + side * away * along.x + share * width_m * along.y};
                const Cell cell = cell_at(at);
                if (labels.contains(cell) && labels.at(cell) != 0) ++votes[labels.at(cell)];
            }
        }
        const auto most = std::max_element(votes.begin(), votes.end(),
                                           [](auto& p, auto& q) { return p.second < q.second; });
        return most == votes.end() ? 0 : most->first;
    }
    /// How wide an opening is as the map shows it: the narrowest of its middle line and the lines
    /// within 0.1 m beside it.
    [[nodiscard]] double width_on_map_m(const Point& jamb_1, const Point& jamb_2) const {
        const double width_m = std::max(distance(jamb_1, jamb_2), 1e-6);
        const Point along{(jamb_2.x - jamb_1.x) / width_m, (jamb_2.y - jamb_1.y) / width_m};
        const Point middle = middle_of(jamb_1, jamb_2);
        double narrowest_m = 2.0 * width_m;
        for (int step = -4; step <= 4; ++step) {
            const double away = 0.025 * step;
            double free_m = 0.0;
            for (const double side : {-1.0, 1.0}) {
                double reach = 0.0;
                while (reach < width_m &&
                       is_free({middle.x - away * along.y + side * reach * along.x,
                                middle.y + away * along.x + side * reach * along.y})) {
                    reach += 0.005;
                }
                free_m += reach;
            }
            narrowest_m = std::min(narrowest_m, free_m);
        }
        return narrowest_m;
    }
    [[nodiscard]] bool has_free_near(const Point& at) const {
        const auto reach = static_cast<std::int32_t>(std::lround(0.15 / map_.resolution_m));
        const Cell center = cell_at(at);
        for (std::int32_t dy = -reach; dy <= reach; ++dy) {
            for (std::int32_t dx = -reach; dx <= reach; ++dx) {
                const Cell cell{center.x + dx, center.y + dy};
                if (map_.states.contains(cell) && map_.states.at(cell) == CellState::free) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    [[nodiscard]] bool is_free(const Point& at) const {
        const Cell cell = cell_at(at);
        return map_.states.contains(cell) && map_.states.at(cell) == CellState::free;
    }
    [[nodiscard]] Cell cell_at(const Point& at) const {
        const Point in_image = transform(image_from_map_, at);
        return {static_cast<std::int32_t>(std::floor(in_image.x / map_.resolution_m)),
                static_cast<std::int32_t>(std::floor(in_image.y / map_.resolution_m))};
    }

    const GridMap& map_;
    Pose image_from_map_;
};

/// "Office 12" -> "Office".
inline std::string use_of(const sim::Building& building, std::size_t room) {
    if (room == 0) return "nothing";
    const std::string& name = building.rooms[room - 1].name;
    return name.substr(0, name.rfind(' '));
}

inline std::string uses_of(const sim::Building& building, std::size_t a, std::size_t b) {
    std::string first = use_of(building, a);
    std::string second = use_of(building, b);
    if (second < first) std::swap(first, second);
    return first + " + " + second;
}

class DoorScorer {
public:
    DoorScorer(const MappedBuilding& mapped, const Segmentation& found)
        : mapped_(mapped), found_(found), beside_(mapped.map) {
        find_seen();
        match();
    }

    [[nodiscard]] DoorScore score() const {
        DoorScore score;
        for (const DoorPair& pair : pairs_) {
            if (is_seen_[pair.truth]) score.pairs.push_back(pair);
        }
        for (std::size_t i = 0; i < is_seen_.size(); ++i) {
            const sim::TrueDoor& door = mapped_.building.doors[i];
            if (door.a == door.b) continue;
            if (!is_seen_[i]) ++score.num_unseen;
            if (!is_seen_[i] || is_true_matched_[i]) continue;
            score.missed.push_back({cause_of_missed(door), middle_of(door.jamb_1, door.jamb_2),
                                    door.width_m, door.is_open_passage,
                                    uses_of(mapped_.building, index(door.a), index(door.b))});
        }
        for (std::size_t i = 0; i < found_.doors.size(); ++i) {
            if (!is_found_matched_[i]) score.extra.push_back(extra(found_.doors[i]));
        }
        return score;
    }

private:
    void find_seen() {
        std::vector<std::size_t> num_cells(mapped_.building.rooms.size() + 1, 0);
        for (const std::uint32_t room : mapped_.truth.values) ++num_cells[room];
        for (const sim::TrueDoor& door : mapped_.building.doors) {
            const auto [a, b] =
                std::pair{beside_.label(mapped_.truth, door.jamb_1, door.jamb_2, 1.0),
                          beside_.label(mapped_.truth, door.jamb_1, door.jamb_2, -1.0)};
            is_seen_.push_back(door.a != door.b && a != 0 && b != 0 && a != b &&
                               num_cells[index(door.a)] > io::kIgnoredRegionPixels &&
                               num_cells[index(door.b)] > io::kIgnoredRegionPixels &&
                               beside_.has_free_near(middle_of(door.jamb_1, door.jamb_2)));
        }
    }
    void match() {
        const auto& doors = mapped_.building.doors;
        std::vector<DoorPair> near;
        for (std::size_t p = 0; p < found_.doors.size(); ++p) {
            const Point at = middle_of(found_.doors[p].jamb_1, found_.doors[p].jamb_2);
            for (std::size_t t = 0; t < doors.size(); ++t) {
                if (doors[t].a == doors[t].b) continue;
                const double away = distance(at, middle_of(doors[t].jamb_1, doors[t].jamb_2));
                if (away <= kSameDoorM) near.push_back({p, t, away});
            }
        }
        std::sort(near.begin(), near.end(), [](const DoorPair& p, const DoorPair& q) {
            return std::tie(p.distance_m, p.predicted, p.truth) <
                   std::tie(q.distance_m, q.predicted, q.truth);
        });
        is_found_matched_.assign(found_.doors.size(), false);
        is_true_matched_.assign(doors.size(), false);
        for (const DoorPair& pair : near) {
            if (is_found_matched_[pair.predicted] || is_true_matched_[pair.truth]) continue;
            is_found_matched_[pair.predicted] = true;
            is_true_matched_[pair.truth] = true;
            pairs_.push_back(pair);
        }
    }
    [[nodiscard]] std::string cause_of_missed(const sim::TrueDoor& door) const {
        const Point at = middle_of(door.jamb_1, door.jamb_2);
        const std::uint32_t a = beside_.label(found_.labels, door.jamb_1, door.jamb_2, 1.0);
        const std::uint32_t b = beside_.label(found_.labels, door.jamb_1, door.jamb_2, -1.0);
        bool is_near = false;
        for (std::size_t i = 0; i < found_.doors.size(); ++i) {
            if (is_found_matched_[i]) continue;
            const Door& other = found_.doors[i];
            is_near =
                is_near || distance(at, middle_of(other.jamb_1, other.jamb_2)) <= kDisplacedDoorM;
        }
        if (is_near) return "displaced by 0.3 to 1 m";
        if (a == 0 || b == 0) return "a side has no room";
        return a == b ? "rooms merged" : "cut more than 1 m away, or no contact";
    }
    [[nodiscard]] DoorError extra(const Door& door) const {
        const Point at = middle_of(door.jamb_1, door.jamb_2);
        const std::uint32_t a = beside_.label(mapped_.truth, door.jamb_1, door.jamb_2, 1.0);
        const std::uint32_t b = beside_.label(mapped_.truth, door.jamb_1, door.jamb_2, -1.0);
        DoorError error{"", at, door.width_m, false, uses_of(mapped_.building, a, b)};
        bool is_missed_near = false;
        bool is_other_near = false;
        for (std::size_t i = 0; i < is_seen_.size(); ++i) {
            const sim::TrueDoor& other = mapped_.building.doors[i];
            if (distance(at, middle_of(other.jamb_1, other.jamb_2)) > kDisplacedDoorM) continue;
            const bool is_missed = is_seen_[i] && !is_true_matched_[i];
            (is_missed ? is_missed_near : is_other_near) = true;
        }
        if (is_missed_near) {
            error.cause = "displaced by 0.3 to 1 m";
        } else if (a == 0 || b == 0) {
            error.cause = "a side is no true room";
        } else if (is_other_near) {
            error.cause =
                a == b ? "over-cut beside a door" : "second cut at a door, or unseen door";
        } else {
            error.cause = a == b ? "over-cut" : "between rooms without a door";
        }
        return error;
    }

    const MappedBuilding& mapped_;
    const Segmentation& found_;
    Beside beside_;
    std::vector<bool> is_seen_;
    std::vector<bool> is_found_matched_;
    std::vector<bool> is_true_matched_;
    std::vector<DoorPair> pairs_;
};

}  // namespace quadcut
