// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/region_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

constexpr double kLineM = 6.0;

}  // namespace

void RegionGraph::Sums::add(const Sums& other) {
    num_cells += other.num_cells;
    sum_x += other.sum_x;
    sum_y += other.sum_y;
    sum_clearance_m += other.sum_clearance_m;
    sum_free_clearance_m += other.sum_free_clearance_m;
    num_unknown += other.num_unknown;
    num_occupied += other.num_occupied;
}

void RegionGraph::Extent::add(const Extent& other) {
    Sums::add(other);
    area_m2 += other.area_m2;
    peak_m = std::max(peak_m, other.peak_m);
    free_peak_m = std::max(free_peak_m, other.free_peak_m);
    num_openings += other.num_openings;
    is_cluttered = is_cluttered || other.is_cluttered;
    hull = hull_of(hull, other.hull);
}

RegionGraph::RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                         const Ground& ground, const Executor& executor)
    : pieces_(pieces),
      ground_(ground),
      region_(num_pieces + 1),
      members_(num_pieces + 1),
      extent_(num_pieces + 1),
      version_(num_pieces + 1, 0),
      borders_(border_saddles(pieces, ground.clearance_m, ground.lines, executor), num_pieces,
               ground.clearance_m, ground.resolution_m),
      free_borders_(border_saddles(pieces, ground.free_clearance_m, ground.lines, executor), num_pieces,
                    ground.free_clearance_m, ground.resolution_m) {
    std::iota(region_.begin(), region_.end(), 0U);
    for (std::uint32_t piece = 1; piece <= num_pieces; ++piece) members_[piece] = {piece};
    struct Piece : Extent {
        HullOfRows rows;
        Hull before;
    };
    const auto width = static_cast<std::size_t>(pieces.width);
    auto extents = tally_by_label<Piece>(
        pieces, executor,
        [&](Piece& piece, const LabelRun& run) {
            const auto num_cells = static_cast<double>(run.num_cells);
            const auto x = static_cast<double>(run.x);
            const auto y = static_cast<double>(run.y);
            piece.num_cells += num_cells;
            piece.sum_x += num_cells * (x + 0.5 * (num_cells - 1.0));
            piece.sum_y += num_cells * y;
            const float* const clearance = &ground.clearance_m.values[run.offset];
            const float* const free_clearance = &ground.free_clearance_m.values[run.offset];
            piece.peak_m = static_cast<double>(
                largest(clearance, run.num_cells, static_cast<float>(piece.peak_m)));
            piece.free_peak_m = static_cast<double>(
                largest(free_clearance, run.num_cells, static_cast<float>(piece.free_peak_m)));
            for (std::size_t i = 0; i < run.num_cells; ++i) {
                piece.sum_clearance_m += static_cast<double>(clearance[i]);
                piece.sum_free_clearance_m += static_cast<double>(free_clearance[i]);
            }
            piece.rows.add(y, x, x + num_cells);
            piece.is_cluttered = piece.is_cluttered ||
                                 !std::equal(clearance, clearance + run.num_cells, free_clearance);
            const auto look = [&](std::size_t at) {
                if (pieces.values[at] != 0) return;
                if (ground.states.values[at] == CellState::unknown) ++piece.num_unknown;
                if (ground.states.values[at] == CellState::occupied) ++piece.num_occupied;
            };
            if (run.x > 0) look(run.offset - 1);
            if (run.x + run.num_cells < width) look(run.offset + run.num_cells);
            for (std::size_t i = run.offset; i < run.offset + run.num_cells; ++i) {
                if (run.y > 0) look(i - width);
                if (i + width < pieces.values.size()) look(i + width);
            }
        },
        [](Piece& piece, Piece& other) {
            piece.before = hull_of(piece.before, other.rows.take());
            piece.add(other);
        });
    for (std::size_t i = 0; i < extents.size(); ++i) {
        extents[i].hull = hull_of(extents[i].before, extents[i].rows.take());
        extent_[i] = extents[i];
    }
    for (Extent& extent : extent_) {
        extent.area_m2 = extent.num_cells * ground.resolution_m * ground.resolution_m;
        extent.shape = shape_of(extent, extent.hull);
    }
}

void RegionGraph::add_beyond(std::uint32_t piece, const Beyond& beyond) {
    extent_[piece].area_m2 += beyond.area_m2;
    extent_[piece].peak_m = std::max(extent_[piece].peak_m, beyond.peak_m);
    extent_[piece].num_openings += beyond.num_openings;
}

std::size_t RegionGraph::num_saddles() const {
    std::size_t num_sides = 0;
    for (std::uint32_t region = 0; region < region_.size(); ++region) {
        num_sides += borders_.of(region).size();
    }
    return num_sides / 2;
}

void RegionGraph::join(std::uint32_t a, std::uint32_t b) {
    if (watcher_) watcher_(a, b);
    borders_.join(a, b, view());
    free_borders_.join(a, b, view());
    for (const std::uint32_t piece : members_[b]) region_[piece] = a;
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    members_[b].clear();
    extent_[a].add(extent_[b]);
    extent_[a].shape = shape_of(extent_[a], extent_[a].hull);
    ++version_[a];
}

BorderMeasure RegionGraph::measure(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    BorderMeasure measure;
    if (auto found = borders_.measure(a, b, view())) measure.narrowing = *found;
    if (!extent_[a].is_cluttered && !extent_[b].is_cluttered) {
        measure.free_narrowing = measure.narrowing;
    } else if (auto found = free_borders_.measure(a, b, view())) {
        measure.free_narrowing = *found;
    }
    describe(a, b, measure);
    return measure;
}

void RegionGraph::measure_around(std::uint32_t region, double max_width_m,
                                 const Executor& executor) {
    borders_.measure_around(region, max_width_m, view(), executor);
    if (extent_[region].is_cluttered) {
        free_borders_.measure_around(region, max_width_m, view(), executor);
    }
}

void RegionGraph::measure_all(double max_width_m, const Executor& executor) {
    borders_.measure_all(max_width_m, view(), executor);
}

BorderMeasure RegionGraph::measure_at(const Saddle& saddle, const Saddle& free_saddle,
                                      std::uint32_t a, std::uint32_t b) const {
    BorderMeasure measure;
    NarrowingGauge gauge(ground_.clearance_m, ground_.resolution_m);
    measure.narrowing = gauge.measure(saddle, view());
    if (!extent_[a].is_cluttered && !extent_[b].is_cluttered) {
        measure.free_narrowing = measure.narrowing;
    } else if (free_saddle.num_contacts > 0) {
        NarrowingGauge free_gauge(ground_.free_clearance_m, ground_.resolution_m);
        measure.free_narrowing = free_gauge.measure(free_saddle, view());
    }
    describe(a, b, measure);
    return measure;
}

RegionShape RegionGraph::shape_of(const Sums& extent, const Hull& hull) const {
    const double cell_m = ground_.resolution_m;
    RegionShape shape;
    shape.area_m2 = extent.num_cells * cell_m * cell_m;
    shape.hull_m2 = hull.area * cell_m * cell_m;
    shape.mean_clearance_m = extent.sum_clearance_m / std::max(1.0, extent.num_cells);
    shape.mean_free_clearance_m = extent.sum_free_clearance_m / std::max(1.0, extent.num_cells);
    const Rectangle around = smallest_rectangle(hull);
    shape.around_m = {around.length * cell_m, around.width * cell_m};
    shape.open_share =
        extent.num_unknown / std::max(1.0, extent.num_unknown + extent.num_occupied);
    return shape;
}

void RegionGraph::fill_sides(std::uint32_t a, std::uint32_t b, const Borders& borders,
                             bool is_free, Narrowing& narrowing) const {
    const auto fill = [&](std::uint32_t region, SideOfSaddle& side) {
        const auto& saddles = borders.of(region);
        side.region_area_m2 = extent_[region].area_m2;
        side.region_peak_m = is_free ? extent_[region].free_peak_m : extent_[region].peak_m;
        side.num_openings =
            extent_[region].num_openings +
            static_cast<std::size_t>(
                std::count_if(saddles.begin(), saddles.end(), [&](const auto& entry) {
                    return entry.second.clearance_m > kFitsM &&
                           extent_[entry.first].area_m2 >= kPlaceM2;
                }));
    };
    fill(narrowing.is_a_narrower ? a : b, narrowing.narrower);
    fill(narrowing.is_a_narrower ? b : a, narrowing.wider);
}

std::array<double, 2> RegionGraph::open_in_line_m(std::uint32_t a, std::uint32_t b,
                                                  const Opening& opening,
                                                  const Raster<float>& clearance) const {
    std::array<double, 2> open_m{};
    if (!opening.has_jambs) return open_m;
    for (std::size_t k = 0; k < 2; ++k) {
        const double sign = k == 0 ? -1.0 : 1.0;
        for (double t = 1.0; t <= kLineM / ground_.resolution_m; t += 1.0) {
            const Cell cell{
                opening.jambs[k].x + static_cast<std::int32_t>(std::floor(0.5 + sign * t * opening.along.x)),
                opening.jambs[k].y + static_cast<std::int32_t>(std::floor(0.5 + sign * t * opening.along.y))};
            if (!pieces_.contains(cell)) break;
            const std::uint32_t region = region_[pieces_.at(cell)];
            const bool is_of_both = region != 0 && (region == a || region == b);
            if (is_of_both && clearance.at(cell) > 0.0F) open_m[k] += ground_.resolution_m;
        }
    }
    if (open_m[0] > open_m[1]) std::swap(open_m[0], open_m[1]);
    return open_m;
}

void RegionGraph::describe(std::uint32_t a, std::uint32_t b, BorderMeasure& measure) const {
    Narrowing& free = measure.free_narrowing;
    if (free.is_a_narrower != measure.narrowing.is_a_narrower) {
        free.is_a_narrower = measure.narrowing.is_a_narrower;
        std::swap(free.narrower, free.wider);
    }
    fill_sides(a, b, borders_, false, measure.narrowing);
    fill_sides(a, b, free_borders_, true, free);
    const std::uint32_t narrower = measure.narrowing.is_a_narrower ? a : b;
    const std::uint32_t wider = measure.narrowing.is_a_narrower ? b : a;
    measure.narrower = extent_[narrower].shape;
    measure.wider = extent_[wider].shape;
    Extent both = extent_[a];
    both.sum_clearance_m += extent_[b].sum_clearance_m;
    both.sum_free_clearance_m += extent_[b].sum_free_clearance_m;
    both.num_unknown += extent_[b].num_unknown;
    both.num_occupied += extent_[b].num_occupied;
    measure.joined = shape_of(both, hull_of(extent_[a].hull, extent_[b].hull));
    measure.open_in_line_m =
        open_in_line_m(a, b, measure.narrowing.opening, ground_.clearance_m);
    measure.free_in_line_m = open_in_line_m(a, b, free.opening, ground_.free_clearance_m);
}

}  // namespace quadcut
