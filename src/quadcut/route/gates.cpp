// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/gates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace quadcut {
namespace {

using RoomPair = std::array<std::uint16_t, 2>;

/// A gate up to this wide, metres, is crossed in its middle; in a wider one there is a crossing at
/// least every metre.
constexpr double kNarrowM = 0.4;
constexpr double kBetweenM = 1.0;

void note_contact(const RobotFloor& floor, Cell cell, Cell next,
                  std::map<RoomPair, std::vector<GateCells>>& contacts) {
    if (!floor.fits(next)) return;
    const std::uint16_t here = floor.labels.at(cell);
    const std::uint16_t there = floor.labels.at(next);
    if (here == there) return;
    if (here < there) {
        contacts[{here, there}].push_back({cell, next});
    } else {
        contacts[{there, here}].push_back({next, cell});
    }
}

std::map<RoomPair, std::vector<GateCells>> find_contacts(const RobotFloor& floor) {
    std::map<RoomPair, std::vector<GateCells>> contacts;
    for_each_cell(floor.labels.box(), [&](Cell cell) {
        if (!floor.fits(cell)) return;
        note_contact(floor, cell, {cell.x + 1, cell.y}, contacts);
        note_contact(floor, cell, {cell.x, cell.y + 1}, contacts);
    });
    return contacts;
}

bool are_near(Cell a, Cell b) { return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1; }

/// Takes what hangs together with the last contact out of `left`.
std::vector<GateCells> take_border(std::vector<GateCells>& left) {
    std::vector<GateCells> border{left.back()};
    left.pop_back();
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Cell cell = border[i][0];
        const auto apart = std::partition(left.begin(), left.end(), [cell](const GateCells& cells) {
            return !are_near(cell, cells[0]);
        });
        border.insert(border.end(), apart, left.end());
        left.erase(apart, left.end());
    }
    return border;
}

/// From end to end: along the line to the farthest cell from any.
void put_in_order(std::vector<GateCells>& border) {
    const auto farthest_from = [&](Cell cell) {
        return *std::max_element(border.begin(), border.end(),
                                 [cell](const GateCells& a, const GateCells& b) {
                                     return cells_between(cell, a[0]) < cells_between(cell, b[0]);
                                 });
    };
    const Cell first = farthest_from(border.front()[0])[0];
    const Cell last = farthest_from(first)[0];
    const auto along = [&](const GateCells& cells) {
        return std::int64_t{cells[0].x - first.x} * (last.x - first.x) +
               std::int64_t{cells[0].y - first.y} * (last.y - first.y);
    };
    std::stable_sort(border.begin(), border.end(),
                     [&](const GateCells& a, const GateCells& b) { return along(a) < along(b); });
}

std::vector<std::uint32_t> choose_crossings(const std::vector<GateCells>& border,
                                            double resolution_m) {
    const auto last = static_cast<std::uint32_t>(border.size() - 1);
    const double width_m =
        static_cast<double>(cells_between(border.front()[0], border.back()[0])) * resolution_m;
    if (width_m <= kNarrowM) return {last / 2};
    const auto num_parts = static_cast<std::uint32_t>(std::ceil(width_m / kBetweenM));
    std::vector<std::uint32_t> places;
    for (std::uint32_t i = 0; i <= num_parts; ++i) places.push_back(last * i / num_parts);
    return places;
}

}  // namespace

std::vector<Gate> find_gates(const RobotFloor& floor) {
    std::vector<Gate> gates;
    for (auto& [rooms, contacts] : find_contacts(floor)) {
        std::reverse(contacts.begin(), contacts.end());
        while (!contacts.empty()) {
            Gate gate{rooms, take_border(contacts), {}};
            put_in_order(gate.border);
            gate.crossings = choose_crossings(gate.border, floor.resolution_m);
            gates.push_back(std::move(gate));
        }
    }
    return gates;
}

}  // namespace quadcut
