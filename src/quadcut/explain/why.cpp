// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/explain/why.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "quadcut/map/line_walk.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/segment/floor.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {
namespace {

constexpr double kBorderWithinM = 1.0;
constexpr double kFusedWithinM = 2.0;

Point middle_of(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

Cell cell_at(const GridMap& map, const Point& place) {
    const Point at = transform(inverse(map.map_from_image), place);
    return cell_of({at.x / map.resolution_m, at.y / map.resolution_m});
}

/// Two rooms beside each other, and how far away, in cells.
struct NearestBorder {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double cells = 0.0;
};

std::optional<NearestBorder> nearest_border(const Raster<std::uint32_t>& rooms, const Point& place,
                                            double within_cells) {
    const auto reach = static_cast<std::int32_t>(std::ceil(within_cells)) + 1;
    const Cell middle = cell_of(place);
    std::optional<NearestBorder> nearest;
    for (std::int32_t y = middle.y - reach; y <= middle.y + reach; ++y) {
        for (std::int32_t x = middle.x - reach; x <= middle.x + reach; ++x) {
            for (const Cell next : {Cell{x + 1, y}, Cell{x, y + 1}}) {
                if (!rooms.contains({x, y}) || !rooms.contains(next)) continue;
                const std::uint32_t a = rooms.at({x, y});
                const std::uint32_t b = rooms.at(next);
                if (a == b || a == 0 || b == 0) continue;
                const Point between{(x + next.x + 1) / 2.0, (y + next.y + 1) / 2.0};
                const double cells = distance(place, between);
                if (cells > within_cells || (nearest && cells >= nearest->cells)) continue;
                nearest = {std::min(a, b), std::max(a, b), cells};
            }
        }
    }
    return nearest;
}

/// Decisions and places of a floor that is laid out.
class Explainer {
public:
    Explainer(const GridMap& map, const Layout& layout, const DecidedCut& decided)
        : map_(map), layout_(layout), decided_(decided) {}

    /// `place` in cells of the layout.
    [[nodiscard]] std::optional<NearBorder> border_at(const Point& place) const {
        const double cell_m = map_.resolution_m;
        if (const auto near = nearest_border(decided_.cut.rooms, place, kBorderWithinM / cell_m)) {
            for (const Decision& decision : decided_.decisions) {
                if (decision.verdict != Verdict::cut) break;
                const std::uint32_t a = decided_.cut.rooms.at(decision.saddle.a);
                const std::uint32_t b = decided_.cut.rooms.at(decision.saddle.b);
                if (std::minmax(a, b) == std::minmax(near->a, near->b)) {
                    return described(decision, near->cells * cell_m);
                }
            }
        }
        const Decision* best = nullptr;
        for (const Decision& decision : decided_.decisions) {
            if (decision.verdict == Verdict::cut) continue;
            if (distance_m(decision, place) > kFusedWithinM) continue;
            if (best == nullptr || decision.log_odds > best->log_odds) best = &decision;
        }
        if (best == nullptr) return std::nullopt;
        return described(*best, distance_m(*best, place));
    }

private:
    [[nodiscard]] double distance_m(const Decision& decision, const Point& place) const {
        const Point a = middle_of(decision.saddle.a);
        const Point b = middle_of(decision.saddle.b);
        return map_.resolution_m * distance(place, {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0});
    }

    [[nodiscard]] NearBorder described(const Decision& decision, double away_m) const {
        const LaidOutFrame frame{layout_, map_.resolution_m, map_.map_from_image};
        return {decision,
                away_m,
                {frame.in_map(middle_of(decision.saddle.a)),
                 frame.in_map(middle_of(decision.saddle.b))},
                granularity_from(decision.log_odds),
                door_contributions(decision.border)};
    }

    const GridMap& map_;
    const Layout& layout_;
    const DecidedCut& decided_;
};

}  // namespace

Why why(const GridMap& map, const SegmentOptions& options, const Point& place,
        const RunOptions& run, std::span<const Point> trajectory) {
    const Cell cell = cell_at(map, place);
    if (!map.states.contains(cell)) return {};
    const CellState state = map.states.at(cell);
    if (state != CellState::free) {
        return {state == CellState::occupied ? PlaceKind::occupied : PlaceKind::unknown, 0.0, {}};
    }
    const Executor executor = run.executor();
    Floor floor = lay_out_floor(map, trajectory, options.rooms.min_component_m2, executor);
    const Layout layout = floor.layout;
    DecidedCut decided = cut_with_decisions(
        {std::move(floor.kept), floor.states, map.resolution_m, {}, options.paper.num_submaps, {}},
        options.rooms, executor);
    std::vector<Cell> way = visited_cells(map, trajectory);
    for (Cell& at : way) at = layout.place_of(at);
    drop_outside(decided.cut.rooms, layout, map.states.box(), way);
    const Cell laid = layout.place_of(cell);
    const Raster<std::uint32_t>& rooms = decided.cut.rooms;
    if (!rooms.contains(laid) || rooms.at(laid) == 0) return {PlaceKind::left_out, 0.0, {}};
    return {PlaceKind::room, static_cast<double>(decided.cut.clearance_m.at(laid)),
            Explainer(map, layout, decided).border_at(middle_of(laid))};
}

}  // namespace quadcut
