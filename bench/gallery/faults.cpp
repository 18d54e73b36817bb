// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/faults.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "quadcut/map/clearance.hpp"

namespace quadcut::gallery {
namespace {

using Labels = Raster<std::uint16_t>;

/// The numbers on the two sides of a border; both 0 where there is none.
struct Beside {
    std::uint16_t a = 0;
    std::uint16_t b = 0;
    [[nodiscard]] bool are_rooms() const { return a != 0 && b != 0; }
    [[nodiscard]] bool is_border() const { return are_rooms() && a != b; }
};

bool is_free(const Exhibit& exhibit, Cell cell) {
    return exhibit.result.map.states.at(cell) == CellState::free;
}

/// Calls visit(side, other cell) for the sides between free cells.
template <typename Visitor>
void for_each_side(const Exhibit& exhibit, const Visitor& visit) {
    const Raster<CellState>& states = exhibit.result.map.states;
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const Cell cell = states.cell(i);
        if (!is_free(exhibit, cell)) continue;
        for (const bool is_upper : {false, true}) {
            const Cell other{cell.x + (is_upper ? 0 : 1), cell.y + (is_upper ? 1 : 0)};
            if (states.contains(other) && is_free(exhibit, other)) {
                visit(CellSide{cell, is_upper}, other);
            }
        }
    }
}

/// Hand-made rooms leave thin gaps between them: the free cells there get the label of the nearest
/// room, as far as half the gap may be.
Labels without_gaps(const Exhibit& exhibit, Labels labels) {
    constexpr double kHalfGapM = 0.5;
    std::vector<Cell> edge;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (labels.values[i] != 0) edge.push_back(labels.cell(i));
    }
    for (double reach_m = 0.0; reach_m < kHalfGapM; reach_m += exhibit.result.map.resolution_m) {
        std::vector<Cell> next;
        for (const Cell cell : edge) {
            for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
                const Cell other{cell.x + step.x, cell.y + step.y};
                if (!labels.contains(other) || labels.at(other) != 0 || !is_free(exhibit, other)) {
                    continue;
                }
                labels.at(other) = labels.at(cell);
                next.push_back(other);
            }
        }
        edge = std::move(next);
    }
    return labels;
}

Beside beside(const Labels& labels, Cell cell, Cell other) {
    return {labels.at(cell), labels.at(other)};
}

/// How far each cell is from a border of these rooms, metres.
Raster<float> distance_to_borders(const Exhibit& exhibit, const Labels& labels) {
    Raster<std::uint8_t> open(labels.box(), 1);
    for_each_side(exhibit, [&](const CellSide& side, Cell other) {
        if (!beside(labels, side.cell, other).is_border()) return;
        open.at(side.cell) = 0;
        open.at(other) = 0;
    });
    return clearance_m(open, exhibit.result.map.resolution_m);
}

/// Borders by the pair of rooms they lie between.
class PairTally {
public:
    void count(const Beside& side) { ++num_sides_[std::minmax(side.a, side.b)]; }
    [[nodiscard]] std::size_t num_long(double least_sides) const {
        return static_cast<std::size_t>(std::count_if(
            num_sides_.begin(), num_sides_.end(),
            [&](const auto& entry) { return static_cast<double>(entry.second) >= least_sides; }));
    }

private:
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> num_sides_;
};

Raster<Verdict> verdicts_of(const Exhibit& exhibit) {
    const Labels& truth = exhibit.truth.rooms.labels;
    const Labels& result = exhibit.result.rooms.labels;
    std::vector<std::uint32_t> match_of_true(exhibit.comparison.truth.size() + 1, 0);
    for (const eval::RoomMatch& match : exhibit.comparison.found) {
        match_of_true[match.truth] = match.predicted;
    }
    Raster<Verdict> verdicts(truth.box());
    for (std::size_t i = 0; i < verdicts.values.size(); ++i) {
        if (exhibit.result.map.states.values[i] != CellState::free) continue;
        Verdict& verdict = verdicts.values[i];
        if (exhibit.left_out.values[i] != 0) {
            verdict = Verdict::left_out;
        } else if (truth.values[i] == 0) {
            verdict = Verdict::none;
        } else if (result.values[i] == 0) {
            verdict = Verdict::unlabelled;
        } else {
            verdict = match_of_true[truth.values[i]] == result.values[i] ? Verdict::right
                                                                         : Verdict::wrong;
        }
    }
    return verdicts;
}

}  // namespace

Faults find_faults(const Exhibit& exhibit) {
    const Labels truth = without_gaps(exhibit, exhibit.truth.rooms.labels);
    const Labels& result = exhibit.result.rooms.labels;
    Faults faults;
    faults.verdicts = verdicts_of(exhibit);
    const Raster<float> to_true = distance_to_borders(exhibit, truth);
    const Raster<float> to_found = distance_to_borders(exhibit, result);
    PairTally over_cuts;
    PairTally missed_cuts;
    for_each_side(exhibit, [&](const CellSide& side, Cell other) {
        const Beside in_truth = beside(truth, side.cell, other);
        const Beside in_result = beside(result, side.cell, other);
        if (!in_truth.are_rooms() || !in_result.are_rooms()) return;
        if (in_result.is_border()) {
            const bool is_near = to_true.at(side.cell) <= kSameBorderM;
            (is_near ? faults.agreed : faults.over_cut).push_back(side);
            if (!is_near) over_cuts.count(in_result);
        } else if (in_truth.is_border() && to_found.at(side.cell) > kSameBorderM) {
            faults.missed.push_back(side);
            missed_cuts.count(in_truth);
        }
    });
    const double least_sides = kLeastCutM / exhibit.result.map.resolution_m;
    faults.num_over_cuts = over_cuts.num_long(least_sides);
    faults.num_missed_cuts = missed_cuts.num_long(least_sides);
    return faults;
}

}  // namespace quadcut::gallery
