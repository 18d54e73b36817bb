// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/glimpses.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

/// Of the border, so much is open to the unknown: of a place that was looked into through an
/// opening; of one that no robot gets into; of others that do not count where one leads; of a part
/// of a room that is none of its own; and of a room that was not seen as a whole.
constexpr double kOpenGlimpse = 0.65;
constexpr double kOpenUnreached = 0.15;
constexpr double kOpenLed = 0.5;
constexpr double kOpenFan = 0.9;
constexpr double kOpenPartly = 0.1;
/// Of all borders: no obstacles were drawn.
constexpr double kOpenMap = 0.9;
/// What a robot fits through, from the middle of one jamb's cell to that of the other.
constexpr double kRobotM = 0.45;
/// A thick wall.
constexpr double kThickWallM = 0.5;
/// Maps in which so much more lies between two regions than is open are drawn: what is unknown
/// there are walls, otherwise gaps between rays.
constexpr double kBetweenInPlans = 0.5;
/// So far a room reaches into corners and cracks that are too narrow for a robot.
constexpr double kCornerM = 0.4;

/// Counts the sides of cells at which a region ends.
class BorderCount {
public:
    BorderCount(const Raster<std::uint32_t>& labels, const Raster<CellState>& states,
                const Layout& layout, double resolution_m)
        : labels_(labels),
          states_(states),
          layout_(layout),
          wall_cells_(static_cast<std::int32_t>(std::lround(kThickWallM / resolution_m))) {}

    void add(RegionBorder& border, const LabelRun& run) const {
        constexpr std::int32_t kBlock = 16;
        const Cell first = labels_.cell(run.offset);
        const auto length = static_cast<std::int32_t>(run.num_cells);
        const std::uint32_t own = labels_.values[run.offset];
        border.num_cells += run.num_cells;
        look(border, first, {first.x - 1, first.y});
        look(border, {first.x + length - 1, first.y}, {first.x + length, first.y});
        for (const std::int32_t dy : {-1, 1}) {
            const std::int32_t y = first.y + dy;
            const bool is_inside = labels_.contains({first.x, y});
            const std::size_t row = is_inside ? labels_.offset({first.x, y}) : 0;
            for (std::int32_t k = 0; k < length;) {
                const auto at = static_cast<std::size_t>(k);
                // Inside of a region, many at once.
                if (is_inside && k + kBlock <= length &&
                    std::memcmp(&labels_.values[row + at], &labels_.values[run.offset + at],
                                kBlock * sizeof(std::uint32_t)) == 0) {
                    k += kBlock;
                    continue;
                }
                if (!is_inside || labels_.values[row + at] != own) {
                    look(border, {first.x + k, first.y}, {first.x + k, y});
                }
                ++k;
            }
        }
    }

private:
    /// From a cell of the region at one beside it. Obstacles in it are furniture, behind which more
    /// than floor may be unknown.
    void look(RegionBorder& border, Cell own, Cell beside) const {
        if (labels_.contains(beside) && labels_.at(beside) != 0) return;
        const CellState there = state(beside);
        if (there == CellState::free) return;
        if (there == CellState::occupied || state(own) == CellState::occupied ||
            has_obstacle_near(beside)) {
            ++border.num_closed;
        } else {
            count_unknown(border, own, beside);
        }
    }

    /// Walls have fringes that are neither seen as floor nor as a wall.
    [[nodiscard]] bool has_obstacle_near(Cell laid_out) const {
        constexpr std::int32_t kFringe = 2;
        const Cell cell = layout_.source(laid_out);
        const Box near = Box{cell, cell}.grown(kFringe).intersected(states_.box());
        for (std::int32_t y = near.low.y; y <= near.high.y; ++y) {
            for (std::int32_t x = near.low.x; x <= near.high.x; ++x) {
                if (states_.at({x, y}) == CellState::occupied) return true;
            }
        }
        return false;
    }

    /// In plans, what is unknown before an obstacle, or between two rooms, is a wall; so may be
    /// what is between two rays that were seen through one window.
    void count_unknown(RegionBorder& border, Cell own, Cell beside) const {
        const Cell step{beside.x - own.x, beside.y - own.y};
        for (std::int32_t k = 0; k < wall_cells_; ++k) {
            beside = {beside.x + step.x, beside.y + step.y};
            const std::uint32_t label = labels_.contains(beside) ? labels_.at(beside) : 0;
            if (label == labels_.at(own)) break;
            if (label != 0) {
                ++border.num_between;
                return;
            }
            if (state(beside) == CellState::occupied) {
                ++border.num_closed;
                return;
            }
        }
        ++border.num_open;
    }

    [[nodiscard]] CellState state(Cell laid_out) const {
        const Cell cell = layout_.source(laid_out);
        return states_.contains(cell) ? states_.at(cell) : CellState::unknown;
    }

    const Raster<std::uint32_t>& labels_;
    const Raster<CellState>& states_;
    const Layout& layout_;
    std::int32_t wall_cells_;
};

/// Maps that show next to no obstacles do not tell what is open.
bool has_obstacles(const std::vector<RegionBorder>& borders) {
    RegionBorder all;
    for (const RegionBorder& border : borders) all += border;
    return all.open_share() <= kOpenMap;
}

/// Of each room, the rooms that a robot gets to from it, by label.
std::vector<std::set<std::size_t>> reached_through_doors(std::size_t num_rooms,
                                                         std::span<const Door> doors) {
    std::vector<std::set<std::size_t>> reached(num_rooms + 1);
    for (const Door& door : doors) {
        if (door.width_m < kRobotM) continue;
        reached[index(door.a)].insert(index(door.b));
        reached[index(door.b)].insert(index(door.a));
    }
    return reached;
}

std::vector<bool> entered_labels(const Raster<std::uint32_t>& labels, std::size_t num_labels,
                                 std::span<const Cell> way) {
    std::vector<bool> is_entered(num_labels, false);
    for (const Cell cell : way) {
        if (labels.contains(cell)) is_entered[labels.at(cell)] = true;
    }
    return is_entered;
}

/// Nothing of that area has a shorter border than a disc.
std::vector<bool> regions_that_may_have_fans(const std::vector<RegionBorder>& borders,
                                             double min_area_m2, double resolution_m) {
    const double least_m = kOpenFan * std::sqrt(4.0 * std::numbers::pi * min_area_m2);
    std::vector<bool> result;
    for (const RegionBorder& border : borders) {
        result.push_back(static_cast<double>(border.num_open) * resolution_m >= least_m);
    }
    return result;
}

/// The cells that a robot reaches, of regions that may have fans: the parts that are not a region's
/// largest, and do not go on beyond the raster, are `apart`.
struct Cores {
    ConnectedParts parts;
    std::vector<bool> is_apart;
    /// Labels of the regions that have such parts.
    std::vector<bool> has_fans;
    bool is_any = false;
};

Cores find_cores(const Raster<std::uint32_t>& labels, const Raster<float>& clearance_m,
                 const std::vector<bool>& may_have_fans, double min_width_m,
                 const Executor& executor) {
    const auto reach = static_cast<float>(min_width_m / 2.0);
    Cores cores;
    cores.parts = connected_parts(
        labels,
        [&](std::size_t i) {
            const std::uint32_t label = labels.values[i];
            return may_have_fans[label] && clearance_m.values[i] >= reach ? label : 0U;
        },
        Connectivity::four, executor);
    const std::vector<std::size_t> num_cells = cores.parts.num_cells();
    const std::vector<bool> goes_on = cores.parts.on_edge();
    cores.is_apart.assign(num_cells.size(), false);
    cores.has_fans.assign(may_have_fans.size(), false);
    std::vector<std::uint32_t> label_of(num_cells.size(), 0);
    std::vector<std::uint32_t> largest(may_have_fans.size(), 0);
    cores.parts.for_each_run(
        [&](const CellRun& run, std::size_t first) { label_of[run.part] = labels.values[first]; });
    const auto rank = [&](std::uint32_t part) {
        return std::pair(part != 0 && goes_on[part], part != 0 ? num_cells[part] : 0);
    };
    for (std::uint32_t part = 1; part < num_cells.size(); ++part) {
        std::uint32_t& best = largest[label_of[part]];
        if (rank(part) > rank(best)) best = part;
    }
    for (std::uint32_t part = 1; part < num_cells.size(); ++part) {
        const std::uint32_t label = label_of[part];
        if (part == largest[label] || goes_on[part]) continue;
        cores.is_apart[part] = cores.has_fans[label] = cores.is_any = true;
    }
    return cores;
}

/// Adds what is beside `front` in the same region to it, cells of `kind` 0 only, a step at a time.
void grow(const Raster<std::uint32_t>& labels, std::vector<std::size_t> front, std::uint8_t own,
          std::size_t max_steps, Raster<std::uint8_t>& kind) {
    for (std::size_t step = 0; step < max_steps && !front.empty(); ++step) {
        std::vector<std::size_t> next_front;
        for (const std::size_t cell : front) {
            for (const std::size_t next : Neighbours(labels, cell, Connectivity::four)) {
                if (labels.values[next] != labels.values[cell] || kind.values[next] != 0) continue;
                kind.values[next] = own;
                next_front.push_back(next);
            }
        }
        front = std::move(next_front);
    }
}

/// The parts of regions that hang on them by cracks, as cells.
std::vector<std::vector<std::size_t>> find_hanging(const Raster<std::uint32_t>& labels,
                                                   const Cores& cores, double resolution_m) {
    constexpr std::uint8_t kMain = 1;
    constexpr std::uint8_t kApart = 2;
    Raster<std::uint8_t> kind(labels.box());
    std::vector<std::size_t> main;
    std::vector<std::size_t> apart;
    cores.parts.for_each_run([&](const CellRun& run, std::size_t first) {
        if (!cores.has_fans[labels.values[first]]) return;
        const bool is_apart = cores.is_apart[run.part];
        for (std::size_t i = first; i < first + (run.end - run.begin); ++i) {
            kind.values[i] = is_apart ? kApart : kMain;
            (is_apart ? apart : main).push_back(i);
        }
    });
    grow(labels, std::move(main), kMain, static_cast<std::size_t>(kCornerM / resolution_m) + 1,
         kind);
    grow(labels, std::move(apart), kApart, labels.values.size(), kind);
    const ConnectedParts hanging = connected_parts(
        labels, [&](std::size_t i) { return kind.values[i] == kApart ? labels.values[i] : 0U; });
    return hanging.cells_of(std::vector<bool>(hanging.count + std::size_t{1}, true));
}

}  // namespace

RegionBorder& RegionBorder::operator+=(const RegionBorder& other) {
    num_cells += other.num_cells;
    num_open += other.num_open;
    num_closed += other.num_closed;
    num_between += other.num_between;
    return *this;
}

double RegionBorder::open_share() const {
    const auto all = static_cast<double>(num_open + num_closed);
    return all == 0.0 ? 0.0 : static_cast<double>(num_open) / all;
}

std::vector<RegionBorder> measure_borders(const Raster<std::uint32_t>& labels,
                                          const Raster<CellState>& states, const Layout& layout,
                                          double resolution_m, const Executor& executor) {
    const BorderCount count(labels, states, layout, resolution_m);
    std::vector<RegionBorder> borders = tally_by_label<RegionBorder>(
        labels, executor,
        [&](RegionBorder& border, const LabelRun& run) { count.add(border, run); },
        [](RegionBorder& border, const RegionBorder& other) { border += other; });
    RegionBorder all;
    for (const RegionBorder& border : borders) all += border;
    const bool is_plan =
        static_cast<double>(all.num_between) > kBetweenInPlans * static_cast<double>(all.num_open);
    for (RegionBorder& border : borders) {
        (is_plan ? border.num_closed : border.num_open) += std::exchange(border.num_between, 0);
    }
    return borders;
}

void split_off_fans(Raster<std::uint32_t>& labels, const Raster<float>& clearance_m,
                    const Raster<CellState>& states, const Layout& layout, double resolution_m,
                    double min_width_m, double min_area_m2, std::span<const Cell> way,
                    const Executor& executor) {
    const std::vector<RegionBorder> borders =
        measure_borders(labels, states, layout, resolution_m, executor);
    if (!has_obstacles(borders)) return;
    const std::vector<bool> may_have_fans =
        regions_that_may_have_fans(borders, min_area_m2, resolution_m);
    if (std::find(may_have_fans.begin(), may_have_fans.end(), true) == may_have_fans.end()) return;
    const Cores cores = find_cores(labels, clearance_m, may_have_fans, min_width_m, executor);
    if (!cores.is_any) return;
    std::vector<std::uint32_t> region_of(borders.size());
    std::iota(region_of.begin(), region_of.end(), 0U);
    for (const std::vector<std::size_t>& cells : find_hanging(labels, cores, resolution_m)) {
        const double area_m2 = static_cast<double>(cells.size()) * resolution_m * resolution_m;
        if (area_m2 < min_area_m2) continue;
        const auto label = static_cast<std::uint32_t>(region_of.size());
        region_of.push_back(labels.values[cells.front()]);
        for (const std::size_t cell : cells) labels.values[cell] = label;
    }
    if (region_of.size() == borders.size()) return;
    const std::vector<RegionBorder> anew =
        measure_borders(labels, states, layout, resolution_m, executor);
    const std::vector<bool> is_entered = entered_labels(labels, region_of.size(), way);
    const auto is_fan = [&](std::uint32_t label) {
        return anew[label].open_share() >= kOpenFan && !is_entered[label];
    };
    for (auto label = static_cast<std::uint32_t>(borders.size()); label < region_of.size();
         ++label) {
        // A fan may also be the larger part, and a room hang on it.
        if (is_fan(label) != is_fan(region_of[label])) region_of[label] = label;
    }
    renumber(labels, region_of, executor);
}

void judge_seen(std::vector<Room>& rooms, const Raster<std::uint32_t>& labels,
                const Raster<CellState>& states, const Layout& layout, double resolution_m,
                std::span<const Door> doors, std::span<const Cell> way, const Executor& executor) {
    std::vector<RegionBorder> borders =
        measure_borders(labels, states, layout, resolution_m, executor);
    if (rooms.empty() || !has_obstacles(borders)) return;
    borders.resize(rooms.size() + 1);
    std::vector<bool> is_entered = entered_labels(labels, borders.size(), way);
    const auto largest =
        std::max_element(borders.begin(), borders.end(),
                         [](const auto& p, const auto& q) { return p.num_cells < q.num_cells; });
    is_entered[static_cast<std::size_t>(largest - borders.begin())] = true;
    const std::vector<std::set<std::size_t>> reached = reached_through_doors(rooms.size(), doors);
    const auto leads_on = [&](std::size_t label) {
        return std::count_if(reached[label].begin(), reached[label].end(), [&](std::size_t other) {
                   return borders[other].open_share() < kOpenLed;
               }) > 1;
    };
    for (std::size_t label = 1; label <= rooms.size(); ++label) {
        Room& room = rooms[label - 1];
        room.open_border = borders[label].open_share();
        const bool is_glimpse =
            !is_entered[label] && ((room.open_border >= kOpenGlimpse && !leads_on(label)) ||
                                   (room.open_border >= kOpenUnreached && reached[label].empty()));
        room.seen = is_glimpse                        ? Seen::glimpse
                    : room.open_border >= kOpenPartly ? Seen::partly
                                                      : Seen::whole;
    }
}

}  // namespace quadcut
