// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/lost_frame.hpp"

#include <algorithm>
#include <vector>

#include "quadcut/map/flood.hpp"

namespace quadcut {
namespace {

/// Of the floor, and of the border around it, so much at least is as it was.
constexpr double kMinFloor = 0.85;
constexpr double kMinBorder = 0.5;
/// Cells of a side at the first look.
constexpr std::int32_t kFirstLook = 96;
/// Of the floor and of the border, that are looked at, about.
constexpr std::size_t kMostCells = 4096;

/// The floor of rooms, and the cells beside it that are in none; not all if they are many.
struct Outline {
    std::vector<Cell> floor;
    std::vector<Cell> border;
};

std::vector<Cell> thinned(const std::vector<Cell>& cells) {
    const std::size_t step = 1 + cells.size() / kMostCells;
    std::vector<Cell> some;
    for (std::size_t i = 0; i < cells.size(); i += step) some.push_back(cells[i]);
    return some;
}

Outline outline_of(const Raster<std::uint16_t>& earlier) {
    Outline all;
    for (std::size_t i = 0; i < earlier.values.size(); ++i) {
        if (earlier.values[i] != 0) {
            all.floor.push_back(earlier.cell(i));
            continue;
        }
        for (const std::size_t next : Neighbours(earlier, i, Connectivity::four)) {
            if (earlier.values[next] == 0) continue;
            all.border.push_back(earlier.cell(i));
            break;
        }
    }
    return {thinned(all.floor), thinned(all.border)};
}

/// How much of an outline is as it was at a place; both 0 to 1.
struct Fit {
    Cell shift;
    double floor = 0.0;
    double border = 0.0;
    [[nodiscard]] double sum() const { return floor + border; }
};

Fit fit_at(const Outline& outline, const Raster<CellState>& states, Cell shift) {
    const auto share = [&](const std::vector<Cell>& cells, bool is_free) {
        const auto count = std::count_if(cells.begin(), cells.end(), [&](Cell cell) {
            const Cell at{cell.x + shift.x, cell.y + shift.y};
            return (states.contains(at) && states.at(at) == CellState::free) == is_free;
        });
        return static_cast<double>(count) /
               static_cast<double>(std::max<std::size_t>(1, cells.size()));
    };
    return {shift, share(outline.floor, true), share(outline.border, false)};
}

/// The best of the places from `low` to `high`, `step` cells apart.
template <typename Better>
Fit best_fit(const Outline& outline, const Raster<CellState>& states, const Box& places,
             std::int32_t step, const Better& value) {
    Fit best;
    for (Cell at = places.low; at.y <= places.high.y; at.y += step) {
        for (at.x = places.low.x; at.x <= places.high.x; at.x += step) {
            const Fit fit = fit_at(outline, states, at);
            if (value(fit) > value(best)) best = fit;
        }
    }
    return best;
}

}  // namespace

std::optional<Cell> find_shift(const Raster<std::uint16_t>& earlier,
                               const Raster<CellState>& states) {
    const Outline outline = outline_of(earlier);
    if (outline.floor.empty() || states.values.empty()) return std::nullopt;
    const std::int32_t most =
        std::max({earlier.width, earlier.height, states.width, states.height});
    const std::int32_t step = 1 + most / kFirstLook;
    const Box all{{states.origin.x - earlier.origin.x - earlier.width,
                   states.origin.y - earlier.origin.y - earlier.height},
                  {states.origin.x - earlier.origin.x + states.width,
                   states.origin.y - earlier.origin.y + states.height}};
    // The border is a line that a coarse look misses; the floor is not.
    const Outline coarse{thinned(outline.floor), {}};
    Fit best = best_fit(coarse, states, all, step, [](const Fit& fit) { return fit.floor; });
    const Box near{{best.shift.x - 2 * step, best.shift.y - 2 * step},
                   {best.shift.x + 2 * step, best.shift.y + 2 * step}};
    best = best_fit(outline, states, near, 1, [](const Fit& fit) { return fit.sum(); });
    if (best.floor < kMinFloor || best.border < kMinBorder) return std::nullopt;
    return best.shift;
}

}  // namespace quadcut
