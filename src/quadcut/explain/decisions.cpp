// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/explain/decisions.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/base/stage_clock.hpp"
#include "quadcut/rooms/door_model.hpp"
#include "quadcut/rooms/fuse.hpp"

namespace quadcut {
namespace {

Verdict verdict_of(const RegionGraph& regions, std::uint32_t a, std::uint32_t b,
                   const Decision& decision, const RoomsOptions& options) {
    const auto is_below = [&](double area_m2) {
        return std::min(regions.area_m2(a), regions.area_m2(b)) < area_m2 ||
               2.0 * std::min(regions.peak_m(a), regions.peak_m(b)) < options.min_passable_m;
    };
    // Joined before anything was measured.
    if (is_below(kMinPieceM2)) return Verdict::too_small;
    if (2.0 * decision.border.narrowing.half_width_m > options.door_width_m)
        return Verdict::too_wide;
    if (decision.log_odds < fuse_threshold(options.granularity)) return Verdict::no_door;
    return is_below(options.min_room_m2) ? Verdict::too_small : Verdict::one_piece;
}

/// The border as it is; cell a of the saddle lies in region a.
Decision measured(RegionGraph& regions, std::uint32_t a, std::uint32_t b) {
    Decision decision;
    decision.saddle = regions.saddles(a).at(b);
    decision.border = regions.measure(a, b);
    decision.log_odds = door_log_odds(decision.border);
    return decision;
}

void add_kept(const RoomsCut& cut, const Ground& ground, const Executor& executor,
              std::vector<Decision>& decisions) {
    const std::uint32_t count =
        cut.rooms.values.empty()
            ? 0
            : *std::max_element(cut.rooms.values.begin(), cut.rooms.values.end());
    RegionGraph rooms(cut.rooms, count, ground, executor);
    for (std::uint32_t a = 1; a <= count; ++a) {
        for (const auto& [b, saddle] : rooms.saddles(a)) {
            // Without clearance there is furniture between, no opening.
            if (b > a && saddle.clearance_m > 0.0F) decisions.push_back(measured(rooms, a, b));
        }
    }
}

}  // namespace

DecidedCut cut_with_decisions(FloorToCut floor, const RoomsOptions& options,
                              const Executor& executor) {
    std::vector<Decision> joins;
    // Nothing of a whole map is beyond it, but this is where the regions are to be had.
    floor.add_beyond = [&](const Raster<std::uint32_t>&, RegionGraph& regions) {
        regions.watch_joins([&](std::uint32_t a, std::uint32_t b) {
            // What becomes one piece need not touch.
            if (regions.saddles(a).count(b) == 0) return;
            if (regions.saddles(a).at(b).clearance_m <= 0.0F) return;
            Decision decision = measured(regions, std::min(a, b), std::max(a, b));
            decision.verdict = verdict_of(regions, a, b, decision, options);
            joins.push_back(decision);
        });
    };
    const double resolution_m = floor.resolution_m;
    const Raster<CellState>& states = floor.states;
    StageClock clock;
    DecidedCut decided;
    decided.cut = cut_into_rooms(std::move(floor), options, clock, executor);
    const RoomsCut& cut = decided.cut;
    add_kept(cut, {cut.clearance_m, cut.free_clearance_m, states, cut.lines, resolution_m},
             executor, decided.decisions);
    decided.decisions.insert(decided.decisions.end(), joins.begin(), joins.end());
    return decided;
}

}  // namespace quadcut
