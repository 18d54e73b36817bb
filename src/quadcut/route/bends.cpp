// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/bends.hpp"

#include <algorithm>

namespace quadcut {
namespace {

constexpr int kSweeps = 3;
/// What a bend keeps off the walls beyond the robot's radius, metres, and how far it is moved for
/// that, cells.
constexpr double kComfortM = 0.15;
constexpr int kMostSteps = 6;

bool is_way(Sight& sight, Cell before, Cell cell, Cell after) {
    return sight.sees(before, cell) && sight.sees(cell, after);
}

float around(Cell before, Cell cell, Cell after) {
    return cells_between(before, cell) + cells_between(cell, after);
}

/// Along a gate the way by it is first shorter, then longer: the shortest, by halves.
Cell best_crossing(const Gate& gate, Cell before, Cell after) {
    std::size_t low = 0;
    std::size_t high = gate.border.size() - 1;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (around(before, gate.border[middle][0], after) <=
            around(before, gate.border[middle + 1][0], after)) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return gate.border[low][0];
}

void slide_along_gates(std::vector<Bend>& way, std::span<const Gate> gates, Sight& sight) {
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
        if (way[i].gate == Bend::kNone) continue;
        const Cell before = way[i - 1].cell;
        const Cell after = way[i + 1].cell;
        const Cell best = best_crossing(gates[way[i].gate], before, after);
        if (around(before, best, after) < around(before, way[i].cell, after) &&
            is_way(sight, before, best, after)) {
            way[i].cell = best;
        }
    }
}

/// Leaves out each bend whose neighbours see each other.
void leave_out(std::vector<Bend>& way, Sight& sight) {
    std::vector<Bend> kept{way.front()};
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
        if (!sight.sees(kept.back().cell, way[i + 1].cell)) kept.push_back(way[i]);
    }
    kept.push_back(way.back());
    way = std::move(kept);
}

/// The neighbour of a cell with the largest clearance; the cell itself at a summit.
Cell uphill(Sight& sight, Cell cell) {
    Cell best = cell;
    float most = sight.clearance_at(cell);
    for_each_cell(Box{{cell.x - 1, cell.y - 1}, {cell.x + 1, cell.y + 1}}, [&](Cell next) {
        const float clearance = sight.clearance_at(next);
        if (clearance <= most) return;
        most = clearance;
        best = next;
    });
    return best;
}

void keep_off_walls(std::vector<Bend>& way, Sight& sight, double radius_m) {
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
        for (int step = 0; step < kMostSteps; ++step) {
            const Cell cell = way[i].cell;
            if (static_cast<double>(sight.clearance_at(cell)) >= radius_m + kComfortM) break;
            const Cell next = uphill(sight, cell);
            if (next == cell || !is_way(sight, way[i - 1].cell, next, way[i + 1].cell)) break;
            way[i].cell = next;
        }
    }
}

}  // namespace

std::vector<Bend> pull_straight(std::vector<Bend> way, std::span<const Gate> gates, Sight& sight,
                                double radius_m) {
    leave_out(way, sight);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        slide_along_gates(way, gates, sight);
        leave_out(way, sight);
    }
    keep_off_walls(way, sight, radius_m);
    return way;
}

}  // namespace quadcut
