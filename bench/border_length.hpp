// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/result.hpp"

// How straight the border between two rooms is.
namespace quadcut {

/// The side that two touching cells of two rooms share. The border passes between their centres:
/// `from` and `to`, in cells, `from` in the room with the first label.
struct BorderSide {
    Point from;
    Point to;
    std::array<Cell, 2> corners;
};

/// A line that leaves the centres of the cells on the sides that they are on.
struct BorderLine {
    double length_cells = 0.0;
    double chord_cells = 0.0;
    /// At least 1; of a straight border in any direction 1.
    [[nodiscard]] double ratio() const {
        return chord_cells > 0.0 ? length_cells / chord_cells : 1.0;
    }
};

/// Counting the sides would make a slanting straight border 1.4 times as long as it is. Any digital
/// straight line, however, has a straight line that passes between all of its pairs of centres. So
/// the border counts as long as the shortest line through all of these gaps, in their order, from
/// the place in the first to the place in the last for which that is the straightest.
/// Dynamic programme over places in each gap. O(sides).
inline BorderLine straightest_line(const std::vector<BorderSide>& sides) {
    constexpr std::size_t kPlaces = 17;
    if (sides.empty()) return {};
    const auto place = [&](std::size_t side, std::size_t k) {
        const double share = static_cast<double>(k) / (kPlaces - 1);
        const auto& [from, to, corners] = sides[side];
        return Point{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    };
    BorderLine best{std::numeric_limits<double>::infinity(), 0.0};
    for (std::size_t start = 0; start < kPlaces; ++start) {
        std::array<double, kPlaces> length{};
        length.fill(std::numeric_limits<double>::infinity());
        length[start] = 0.0;
        for (std::size_t side = 1; side < sides.size(); ++side) {
            std::array<double, kPlaces> next{};
            for (std::size_t k = 0; k < kPlaces; ++k) {
                next[k] = std::numeric_limits<double>::infinity();
                for (std::size_t before = 0; before < kPlaces; ++before) {
                    next[k] = std::min(next[k], length[before] + distance(place(side - 1, before),
                                                                          place(side, k)));
                }
            }
            length = next;
        }
        for (std::size_t end = 0; end < kPlaces; ++end) {
            const double chord = distance(place(0, start), place(sides.size() - 1, end));
            if (length[end] - chord < best.length_cells - best.chord_cells) {
                best = {length[end], chord};
            }
        }
    }
    return best;
}

/// All sides between the rooms `a` and `b` within a box.
inline std::vector<BorderSide> find_border_sides(const Raster<std::uint16_t>& labels, std::size_t a,
                                                 std::size_t b, const Box& box) {
    std::vector<BorderSide> sides;
    const auto meet = [&](Cell p, Cell q, std::array<Cell, 2> corners) {
        if (!labels.contains(p) || !labels.contains(q)) return;
        const std::size_t at_p = labels.at(p);
        const std::size_t at_q = labels.at(q);
        if (!((at_p == a && at_q == b) || (at_p == b && at_q == a))) return;
        if (at_p == b) std::swap(p, q);
        sides.push_back({{p.x + 0.5, p.y + 0.5}, {q.x + 0.5, q.y + 0.5}, corners});
    };
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y) {
        for (std::int32_t x = box.low.x; x <= box.high.x; ++x) {
            meet({x, y}, {x + 1, y}, {{{x + 1, y}, {x + 1, y + 1}}});
            meet({x, y}, {x, y + 1}, {{{x, y + 1}, {x + 1, y + 1}}});
        }
    }
    return sides;
}

/// Sides in runs, each run in the order in which one walks along it, from its end if it has one.
inline std::vector<std::vector<BorderSide>> order_border_sides(
    const std::vector<BorderSide>& sides) {
    const auto key = [](Cell cell) { return std::pair{cell.y, cell.x}; };
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::size_t>> at_corner;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        for (const Cell corner : sides[i].corners) at_corner[key(corner)].push_back(i);
    }
    std::vector<bool> is_taken(sides.size(), false);
    std::vector<std::vector<BorderSide>> runs;
    const auto walk = [&](std::size_t side, Cell corner) {
        std::vector<BorderSide> run;
        bool goes_on = true;
        while (goes_on) {
            is_taken[side] = true;
            run.push_back(sides[side]);
            corner = sides[side].corners[sides[side].corners[0] == corner ? 1 : 0];
            goes_on = false;
            for (const std::size_t next : at_corner[key(corner)]) {
                if (is_taken[next]) continue;
                side = next;
                goes_on = true;
                break;
            }
        }
        runs.push_back(std::move(run));
    };
    // Ends first; what is left after that are closed lines.
    for (const std::size_t num_at_start : {1, 2, 3, 4}) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            for (const Cell corner : sides[i].corners) {
                if (!is_taken[i] && at_corner[key(corner)].size() == num_at_start) walk(i, corner);
            }
        }
    }
    return runs;
}

/// The border of the two rooms of a door, as far as it belongs to the opening. `image_from_map`
/// takes the map frame to the image's, metres.
inline BorderLine measure_border(const Raster<std::uint16_t>& labels, const Door& door,
                                 const Pose& image_from_map, double resolution_m) {
    const auto in_cells = [&](const Point& point) {
        const Point in_image = transform(image_from_map, point);
        return Point{in_image.x / resolution_m, in_image.y / resolution_m};
    };
    const Point jamb_1 = in_cells(door.jamb_1);
    const Point jamb_2 = in_cells(door.jamb_2);
    const Point middle{0.5 * (jamb_1.x + jamb_2.x), 0.5 * (jamb_1.y + jamb_2.y)};
    const double half_width = 0.5 * distance(jamb_1, jamb_2);
    const double reach = half_width + 0.2 / resolution_m;
    const auto box_reach = static_cast<std::int32_t>(2.0 * reach + 1.0 / resolution_m);
    const Cell center{static_cast<std::int32_t>(middle.x), static_cast<std::int32_t>(middle.y)};
    const Box box{{center.x - box_reach, center.y - box_reach},
                  {center.x + box_reach, center.y + box_reach}};
    const auto place_along = [&](const BorderSide& side) {
        return (side.from.x - jamb_1.x) * (jamb_2.x - jamb_1.x) +
               (side.from.y - jamb_1.y) * (jamb_2.y - jamb_1.y);
    };
    auto runs = order_border_sides(find_border_sides(labels, index(door.a), index(door.b), box));
    std::erase_if(runs, [&](const std::vector<BorderSide>& run) {
        return std::none_of(run.begin(), run.end(), [&](const BorderSide& side) {
            return distance(side.from, middle) <= reach;
        });
    });
    // An obstacle in the opening interrupts the border: what is left of it counts as one line.
    for (std::vector<BorderSide>& run : runs) {
        if (place_along(run.front()) > place_along(run.back()))
            std::reverse(run.begin(), run.end());
    }
    std::sort(runs.begin(), runs.end(), [&](const auto& p, const auto& q) {
        return place_along(p.front()) < place_along(q.front());
    });
    std::vector<BorderSide> line;
    for (const std::vector<BorderSide>& run : runs) line.insert(line.end(), run.begin(), run.end());
    return straightest_line(line);
}

}  // namespace quadcut
