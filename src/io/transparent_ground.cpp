// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/transparent_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/connected_parts.hpp"

namespace quadcut::io {
namespace {

/// Half of the widest opening that is taken for a door.
constexpr double kHalfOpening = 0.75;

/// The cells of a map with a margin of open ground, through which all that is outside is connected.
class Surroundings {
public:
    explicit Surroundings(const GridMap& map)
        : resolution_m_(map.resolution_m),
          margin_(static_cast<std::int32_t>(std::ceil(2.0 * kHalfOpening / resolution_m_)) + 3),
          box_(map.states.box()),
          wide_({{box_.low.x - margin_, box_.low.y - margin_},
                 {box_.high.x + margin_, box_.high.y + margin_}},
                1) {
        for (std::size_t i = 0; i < map.states.values.size(); ++i) {
            wide_.at(map.states.cell(i)) = map.states.values[i] == CellState::free ? 1 : 0;
        }
        Raster<float> distance_m = clearance_m(wide_, resolution_m_);
        for (std::size_t i = 0; i < wide_.values.size(); ++i) {
            wide_.values[i] = distance_m.values[i] > kHalfOpening ? 1 : 0;
        }
        from_outside_m_ = clearance_m(not_outside(), resolution_m_, {}, std::move(distance_m));
    }

    /// Whether the disc of an opening fits around a cell.
    [[nodiscard]] bool is_wide(Cell cell) const { return wide_.at(cell) != 0; }
    /// Whether the disc covers the cell on some way in from the edge.
    [[nodiscard]] bool is_reached(Cell cell) const {
        return from_outside_m_.at(cell) <= kHalfOpening + 2.0 * resolution_m_;
    }

private:
    /// 0 where the disc's centre comes from the edge.
    [[nodiscard]] Raster<std::uint8_t> not_outside() const {
        const ConnectedParts parts =
            connected_parts(wide_, [this](std::size_t i) { return wide_.values[i]; });
        const auto middle = static_cast<std::uint32_t>(margin_ / 2);
        std::vector<std::uint8_t> values(parts.count + 1, 1);
        values[parts.part_at(middle, middle)] = 0;
        values[0] = 1;
        auto open = Raster<std::uint8_t>::unset(wide_.box());
        parts.paint(values, open);
        return open;
    }

    double resolution_m_;
    std::int32_t margin_;
    Box box_;
    Raster<std::uint8_t> wide_;
    Raster<float> from_outside_m_;
};

/// For each part, whether it has a cell that is wide.
std::vector<bool> parts_with_width(const ConnectedParts& parts, const Raster<CellState>& states,
                                   const Surroundings& surroundings) {
    std::vector<bool> found(parts.count + 1, false);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        for (std::size_t i = 0; i < run.end - run.begin && !found[run.part]; ++i) {
            found[run.part] = surroundings.is_wide(states.cell(first + i));
        }
    });
    return found;
}

}  // namespace

bool is_drawn_on_transparent(const GreyTally& tally, const MapKeys& keys) {
    constexpr double kNearlyNothing = 0.01;
    constexpr double kLeastGround = 0.25;
    std::uint64_t num_free = 0;
    for (std::size_t grey = 0; grey < tally.counts.size(); ++grey) {
        const CellState state = state_of_shade(static_cast<double>(grey) / kWhite, keys);
        if (state == CellState::free) num_free += tally.counts[grey];
    }
    const auto ground = static_cast<double>(tally.num_transparent);
    const auto all = static_cast<double>(tally.count() + tally.num_not_opaque);
    return tally.count() > num_free && ground >= kLeastGround * all &&
           static_cast<double>(num_free) <= kNearlyNothing * ground;
}

WalledFloor take_outside_away(GridMap map) {
    const Surroundings surroundings(map);
    Raster<CellState>& states = map.states;
    const ConnectedParts free = free_parts(states);
    const std::vector<bool> is_on_edge = free.on_edge();
    // Key 1 is enclosed by walls, 2 has leaked out through an opening.
    Raster<std::uint8_t> inside(states.box());
    free.for_each_run([&](const CellRun& run, std::size_t first) {
        const bool has_leaked = is_on_edge[run.part];
        for (std::size_t i = first; i < first + run.end - run.begin; ++i) {
            const bool is_out = has_leaked && surroundings.is_reached(states.cell(i));
            inside.values[i] = is_out ? 0 : has_leaked ? 2 : 1;
        }
    });
    const ConnectedParts parts =
        connected_parts(inside, [&](std::size_t i) { return inside.values[i]; });
    const std::vector<bool> is_wide = parts_with_width(parts, states, surroundings);
    WalledFloor floor;
    floor.is_enclosed = std::find(is_wide.begin(), is_wide.end(), true) != is_wide.end();
    if (floor.is_enclosed) {
        for (std::size_t i = 0; i < inside.values.size(); ++i) {
            if (states.values[i] == CellState::free && inside.values[i] == 0) {
                states.values[i] = CellState::unknown;
            }
        }
        // What is narrow and open to the outside is a niche of the facade.
        parts.for_each_run([&](const CellRun& run, std::size_t first) {
            if (inside.values[first] != 2 || is_wide[run.part]) return;
            std::fill_n(states.values.begin() + static_cast<std::ptrdiff_t>(first),
                        run.end - run.begin, CellState::unknown);
        });
    }
    floor.map = std::move(map);
    return floor;
}

}  // namespace quadcut::io
