// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/regions.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

constexpr double kOutlineM = 0.1;
/// Of the border of a pocket, how much has the room behind it: of a small one, of a larger one.
constexpr double kMinShare = 0.25;
constexpr double kMinShareAround = 0.6;
/// A table that one room is all around of may be so much larger than a pocket beside a room.
constexpr double kTimesLarger = 5.0;

template <typename Key>
std::uint32_t most_frequent(const std::map<Key, std::size_t>& counts) {
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& p, const auto& q) { return p.second < q.second; });
    return most == counts.end() ? 0 : most->first;
}

bool is_set(const std::vector<bool>& flags, std::uint32_t label) {
    return label < flags.size() && flags[label];
}

/// The cells of every part of a region but its largest.
std::vector<std::vector<std::size_t>> detached_parts(const Raster<std::uint32_t>& labels,
                                                     const std::vector<bool>& goes_on,
                                                     const Executor& executor) {
    const ConnectedParts parts = connected_parts(
        labels, [&](std::size_t i) { return labels.values[i]; }, Connectivity::four, executor);
    const std::vector<std::size_t> num_cells = parts.num_cells();
    std::vector<bool> is_detached(num_cells.size(), false);
    std::vector<std::uint32_t> largest;
    std::uint32_t num_seen = 0;
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        // Parts are numbered in the order in which they are come by.
        if (run.part <= num_seen) return;
        num_seen = run.part;
        const std::uint32_t label = labels.values[first];
        if (is_set(goes_on, label)) return;
        if (label >= largest.size()) largest.resize(label + std::size_t{1}, 0);
        std::uint32_t& best = largest[label];
        const bool is_larger = best == 0 || num_cells[run.part] > num_cells[best];
        if (best != 0) is_detached[is_larger ? best : run.part] = true;
        if (is_larger) best = run.part;
    });
    return parts.cells_of(is_detached);
}

/// The label 0 in place of those that are to be dropped.
template <typename IsDropped>
void drop(Raster<std::uint32_t>& labels, std::size_t num_labels, const Executor& executor,
          const IsDropped& is_dropped) {
    std::vector<std::uint32_t> now(num_labels, 0);
    bool is_any = false;
    for (std::uint32_t label = 1; label < num_labels; ++label) {
        if (is_dropped(label)) {
            is_any = true;
        } else {
            now[label] = label;
        }
    }
    if (is_any) renumber(labels, now, executor);
}

/// Walks from the pocket through what is neither free nor labelled, up to `max_steps` cells, to
/// rooms; counts the ways by room, and remembers where each cell was reached from.
struct OutlineWalk {
    /// A cell of the outline, and the place in `reached` of the one before it; its own in the
    /// first.
    struct Reached {
        std::size_t cell = 0;
        std::size_t from = 0;
    };
    std::map<std::uint32_t, std::size_t> ways;
    std::vector<Reached> reached;
    /// Rooms, and the place in `reached` of the cell beside them.
    std::vector<std::pair<std::uint32_t, std::size_t>> arrivals;
    std::size_t num_starts = 0;
};

/// The labels are as before when it returns.
OutlineWalk walk_through_outline(Raster<std::uint32_t>& labels, const Raster<CellState>& states,
                                 const std::vector<std::size_t>& pocket, std::size_t max_steps) {
    constexpr auto kReached = static_cast<std::uint32_t>(-1);
    OutlineWalk walk;
    // A pocket does not touch the edge of the raster.
    const auto width = static_cast<std::size_t>(labels.width);
    for (const std::size_t cell : pocket) {
        for (const std::size_t next : {cell - 1, cell + 1, cell - width, cell + width}) {
            if (states.values[next] == CellState::free || labels.values[next] != 0) continue;
            labels.values[next] = kReached;
            walk.reached.push_back({next, walk.reached.size()});
        }
    }
    walk.num_starts = walk.reached.size();
    std::size_t first = 0;
    for (std::size_t step = 0; step < max_steps; ++step) {
        const std::size_t last = walk.reached.size();
        for (; first < last; ++first) {
            const std::size_t cell = walk.reached[first].cell;
            for (const std::size_t next : Neighbours(labels, cell, Connectivity::four)) {
                const std::uint32_t label = labels.values[next];
                if (label == kReached) continue;
                if (label != 0) {
                    ++walk.ways[label];
                    walk.arrivals.emplace_back(label, first);
                } else if (states.values[next] != CellState::free) {
                    labels.values[next] = kReached;
                    walk.reached.push_back({next, first});
                }
            }
        }
    }
    for (const OutlineWalk::Reached& reached : walk.reached) labels.values[reached.cell] = 0;
    return walk;
}

/// Gives the outline's cells on the ways that lead to `room`, or all ways when that is 0.
void bridge(Raster<std::uint32_t>& labels, const OutlineWalk& walk, std::uint32_t room,
            std::uint32_t label) {
    for (const auto& [reached, arrival] : walk.arrivals) {
        if (room != 0 && reached != room) continue;
        for (std::size_t at = arrival;; at = walk.reached[at].from) {
            std::uint32_t& own = labels.values[walk.reached[at].cell];
            if (own != 0) break;
            own = label;
        }
    }
}

/// The cells of free space that may be a pocket.
std::vector<std::vector<std::size_t>> find_pockets(const Raster<std::uint32_t>& labels,
                                                   const Raster<CellState>& states,
                                                   double max_pocket_cells,
                                                   const Executor& executor) {
    const ConnectedParts parts = connected_parts(
        labels,
        [&](std::size_t i) {
            return states.values[i] != CellState::free ? 0U : labels.values[i] != 0 ? 2U : 1U;
        },
        Connectivity::four, executor);
    return parts.cells_of(parts.islands(std::floor(kTimesLarger * max_pocket_cells) + 1.0));
}

}  // namespace

void connect_regions(Raster<std::uint32_t>& labels, const std::vector<bool>& goes_on,
                     const Executor& executor) {
    std::vector<std::vector<std::size_t>> waiting = detached_parts(labels, goes_on, executor);
    for (const auto& cells : waiting) {
        for (const std::size_t cell : cells) labels.values[cell] = 0;
    }
    // Only what is connected already gives its label: a part may have to wait for its neighbour.
    for (bool is_progress = true; is_progress;) {
        is_progress = false;
        std::vector<std::vector<std::size_t>> still_waiting;
        for (auto& cells : waiting) {
            std::map<std::uint32_t, std::size_t> contacts;
            for (const std::size_t cell : cells) {
                for (const std::size_t next : Neighbours(labels, cell, Connectivity::four)) {
                    if (labels.values[next] != 0) ++contacts[labels.values[next]];
                }
            }
            const std::uint32_t heir = most_frequent(contacts);
            if (heir == 0) {
                still_waiting.push_back(std::move(cells));
                continue;
            }
            is_progress = true;
            for (const std::size_t cell : cells) labels.values[cell] = heir;
        }
        waiting = std::move(still_waiting);
    }
}

void drop_impassable(Raster<std::uint32_t>& labels, const Raster<float>& clearance_m,
                     double min_width_m, const std::vector<bool>& goes_on,
                     const Executor& executor) {
    const auto widest = tally_by_label<float>(
        labels, executor,
        [&](float& peak, const LabelRun& run) {
            peak = largest(&clearance_m.values[run.offset], run.num_cells, peak);
        },
        [](float& peak, float other) { peak = std::max(peak, other); });
    drop(labels, widest.size(), executor, [&](std::uint32_t label) {
        return 2.0 * static_cast<double>(widest[label]) < min_width_m && !is_set(goes_on, label);
    });
}

void drop_without_floor(Raster<std::uint32_t>& labels, const Raster<CellState>& states,
                        const Executor& executor) {
    const auto floor = tally_by_label<std::uint8_t>(
        labels, executor,
        [&](std::uint8_t& seen, const LabelRun& run) {
            if (seen == 0 &&
                std::memchr(&states.values[run.offset], static_cast<int>(CellState::free),
                            run.num_cells) != nullptr) {
                seen = 1;
            }
        },
        [](std::uint8_t& seen, std::uint8_t other) { seen |= other; });
    drop(labels, floor.size(), executor, [&](std::uint32_t label) { return floor[label] == 0; });
}

Adoption adopt_pockets(Raster<std::uint32_t>& labels, const Raster<CellState>& states,
                       double resolution_m, double max_pocket_m2, const Executor& executor) {
    const double max_pocket_cells = max_pocket_m2 / (resolution_m * resolution_m);
    const auto max_small = static_cast<std::size_t>(max_pocket_cells);
    // The thickest outline.
    const auto outline_cells =
        static_cast<std::size_t>(std::max(1L, std::lround(kOutlineM / resolution_m)));
    const auto num_cells = tally_by_label<std::size_t>(
        labels, executor, [](std::size_t& count, const LabelRun& run) { count += run.num_cells; },
        [](std::size_t& count, std::size_t other) { count += other; });
    Adoption adoption;
    for (const std::vector<std::size_t>& pocket :
         find_pockets(labels, states, max_pocket_cells, executor)) {
        const std::uint32_t label = labels.values[pocket.front()];
        const bool is_room = label != 0;
        // It is connected with a room through furniture.
        if (is_room && num_cells[label] > 2 * pocket.size()) continue;
        const bool is_small = pocket.size() <= max_small;
        std::vector<std::uint32_t> own;
        for (const std::size_t cell : pocket) own.push_back(std::exchange(labels.values[cell], 0));
        const OutlineWalk walk = walk_through_outline(labels, states, pocket, outline_cells);
        const std::uint32_t room = most_frequent(walk.ways);
        std::size_t num_ways = 0;
        for (const auto& [reached, count] : walk.ways) num_ways += count;
        const auto has_share = [&](std::size_t ways, double share) {
            return static_cast<double>(ways) >= share * static_cast<double>(walk.num_starts);
        };
        // Two small rooms beside each other are no pockets of each other.
        const bool is_adopted =
            room != 0 && (!is_room || num_cells[room] > std::max(max_small, 2 * pocket.size())) &&
            (is_small || walk.ways.size() == 1) &&
            has_share(walk.ways.at(room), is_small ? kMinShare : kMinShareAround);
        for (std::size_t i = 0; i < pocket.size(); ++i) {
            labels.values[pocket[i]] = is_adopted ? room : own[i];
        }
        if (is_adopted) {
            adoption.is_any = true;
            bridge(labels, walk, room, room);
        } else if (is_room && walk.ways.size() > 1 && has_share(num_ways, kMinShareAround) &&
                   std::count(own.begin(), own.end(), label) ==
                       static_cast<std::ptrdiff_t>(own.size())) {
            adoption.enclosures.push_back({label, {}});
            for (const auto& [reached, count] : walk.ways) {
                adoption.enclosures.back().around.push_back(reached);
            }
            bridge(labels, walk, 0, label);
        }
    }
    return adoption;
}

}  // namespace quadcut
