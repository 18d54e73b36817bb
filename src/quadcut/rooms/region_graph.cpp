// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/region_graph.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "quadcut/map/morton.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

constexpr double kLineM = 6.0;
constexpr std::size_t kShapesPerChunk = 16;
/// Fewer measures take less time than to wake up a thread.
constexpr std::size_t kFewForAThread = 6;

std::size_t index_of(Among obstacles) { return obstacles == Among::walls ? 0 : 1; }

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
    corners.insert(corners.end(), other.corners.begin(), other.corners.end());
    is_described = false;
}

RegionGraph::RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                         const Ground& ground, const Executor& executor)
    : pieces_(pieces),
      ground_(ground),
      region_(num_pieces + 1),
      members_(num_pieces + 1),
      extent_(num_pieces + 1),
      version_(num_pieces + 1, 0),
      walks_(num_pieces) {
    for (const BorderSaddles& saddles : border_saddles(
             pieces, ground.clearance_m, ground.free_clearance_m, ground.lines, executor)) {
        borders_.emplace_back(saddles, num_pieces);
    }
    std::iota(region_.begin(), region_.end(), 0U);
    for (std::uint32_t piece = 1; piece <= num_pieces; ++piece) members_[piece] = {piece};
    struct Piece : Extent {
        HullOfRows rows;
    };
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
            add_sides(run, piece);
        },
        [](Piece& piece, Piece& other) {
            other.corners = other.rows.take().corners;
            piece.add(other);
        });
    for (std::size_t i = 0; i < extents.size(); ++i) extent_[i] = std::move(extents[i]);
    for (Extent& extent : extent_) {
        extent.area_m2 = extent.num_cells * ground.resolution_m * ground.resolution_m;
    }
}

void RegionGraph::add_sides(const LabelRun& run, Sums& sums) const {
    const auto width = static_cast<std::size_t>(pieces_.width);
    const auto look = [&](std::size_t at) {
        if (pieces_.values[at] != 0) return;
        if (ground_.states.values[at] == CellState::unknown) ++sums.num_unknown;
        if (ground_.states.values[at] == CellState::occupied) ++sums.num_occupied;
    };
    if (run.x > 0) look(run.offset - 1);
    if (run.x + run.num_cells < width) look(run.offset + run.num_cells);
    for (std::size_t i = run.offset; i < run.offset + run.num_cells; ++i) {
        if (run.y > 0) look(i - width);
        if (i + width < pieces_.values.size()) look(i + width);
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
        num_sides += saddles(region).size();
    }
    return num_sides / 2;
}

void RegionGraph::join(std::uint32_t a, std::uint32_t b) {
    if (watcher_) watcher_(a, b);
    for (Borders& borders : borders_) borders.join(a, b);
    walks_.join(a, b, region_);
    for (const std::uint32_t piece : members_[b]) region_[piece] = a;
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    members_[b].clear();
    extent_[a].add(extent_[b]);
    ++version_[a];
}

NumOpenings RegionGraph::num_openings(std::uint32_t region) const {
    NumOpenings num{};
    for (std::size_t k = 0; k < num.size(); ++k) {
        const auto& saddles = borders_[k].of(region);
        const auto own = std::count_if(saddles.begin(), saddles.end(), [&](const auto& entry) {
            return entry.second.clearance_m > kFitsM && extent_[entry.first].area_m2 >= kPlaceM2;
        });
        num[k] = extent_[region].num_openings + static_cast<std::size_t>(own);
    }
    return num;
}

BorderMeasure RegionGraph::measure(std::uint32_t a, std::uint32_t b) {
    const RegionPair pair = std::minmax(a, b);
    look_at({&pair, 1}, {});
    return measured(pair, num_openings(pair.first), num_openings(pair.second));
}

void RegionGraph::collect_unseen(const RegionPair& pair, Among obstacles, Unseen& unseen) {
    Borders& borders = borders_[index_of(obstacles)];
    const Saddle* const saddle = borders.find(pair.first, pair.second);
    if (saddle == nullptr) return;
    const auto [opening, is_new] = borders.place_for_opening(pair.first, pair.second);
    if (is_new) unseen.openings.emplace_back(obstacles, saddle, opening);
    const auto add = [&](std::uint32_t region, Cell seed) {
        const auto [walk, is_new_walk] = walks_.place_for(region, pieces_.offset(seed));
        if (is_new_walk) unseen.walks.emplace_back(seed, walk);
    };
    add(pair.first, saddle->a);
    add(pair.second, saddle->b);
}

void RegionGraph::look_at(std::span<const RegionPair> pairs, const Executor& executor) {
    Unseen unseen;
    for (const RegionPair& pair : pairs) {
        for (const std::uint32_t region : {pair.first, pair.second}) {
            if (extent_[region].is_described) continue;
            extent_[region].is_described = true;
            unseen.shapes.push_back(&extent_[region]);
        }
        collect_unseen(pair, Among::walls, unseen);
        if (is_cluttered(pair)) collect_unseen(pair, Among::all, unseen);
    }
    // What lies near each other looks at the same cells.
    const Box box = pieces_.box();
    std::sort(unseen.walks.begin(), unseen.walks.end(), [&](const auto& p, const auto& q) {
        return block_code(p.first, box) < block_code(q.first, box);
    });
    std::sort(unseen.openings.begin(), unseen.openings.end(), [&](const auto& p, const auto& q) {
        return block_code(std::get<const Saddle*>(p)->a, box) <
               block_code(std::get<const Saddle*>(q)->a, box);
    });
    // A gauge for each thread. Some walks need far longer than others: one is taken at a time.
    const std::size_t num_walks = unseen.walks.size();
    const std::size_t num_measured = num_walks + unseen.openings.size();
    const std::size_t num_all = num_measured + unseen.shapes.size();
    const std::size_t num_parts = std::min(
        num_all / kFewForAThread + 1, static_cast<std::size_t>(std::max(1, executor.num_threads)));
    while (gauges_.size() < num_parts) gauges_.push_back(gauge());
    std::atomic<std::size_t> next = 0;
    parallel_for(executor, num_parts, 1, [&](std::size_t part, std::size_t) {
        for (std::size_t i = next++; i < num_all; i = next++) {
            if (i < num_walks) {
                const auto& [seed, walk] = unseen.walks[i];
                *walk = gauges_[part].walk_outward(seed, view());
            } else if (i >= num_measured) {
                describe(*unseen.shapes[i - num_measured]);
            } else {
                const auto& [obstacles, saddle, opening] = unseen.openings[i - num_walks];
                *opening = measure_opening(clearance(obstacles), ground_.resolution_m, *saddle);
            }
        }
    });
}

Narrowing RegionGraph::narrowing_of(const RegionPair& pair, Among obstacles) const {
    const auto [a, b] = pair;
    const Borders& borders = borders_[index_of(obstacles)];
    const Saddle* const saddle = borders.find(a, b);
    if (saddle == nullptr) return {};
    const Opening& opening = borders.opening(a, b);
    const auto side = [&](std::uint32_t region, Cell seed) {
        return side_of(walks_.from(region, pieces_.offset(seed)), obstacles, opening.along);
    };
    return put_together(*saddle, opening, side(a, saddle->a), side(b, saddle->b),
                        ground_.resolution_m);
}

BorderMeasure RegionGraph::measured(const RegionPair& pair, const NumOpenings& openings_a,
                                    const NumOpenings& openings_b) const {
    BorderMeasure measure;
    measure.narrowing = narrowing_of(pair, Among::walls);
    measure.free_narrowing =
        is_cluttered(pair) ? narrowing_of(pair, Among::all) : measure.narrowing;
    describe(pair, openings_a, openings_b, measure);
    return measure;
}

BorderMeasure RegionGraph::measure_at(const Saddle& saddle, const Saddle& free_saddle,
                                      const RegionPair& pair, NarrowingGauge& gauge) const {
    const auto walk_from = [&](const Saddle& at) {
        return std::array{gauge.walk_outward(at.a, view()), gauge.walk_outward(at.b, view())};
    };
    const auto narrowing = [&](const Saddle& at, Among obstacles,
                               const std::array<WalkedSide, 2>& walks) {
        const Opening opening = measure_opening(clearance(obstacles), ground_.resolution_m, at);
        return put_together(at, opening, side_of(walks[0], obstacles, opening.along),
                            side_of(walks[1], obstacles, opening.along), ground_.resolution_m);
    };
    const auto walks = walk_from(saddle);
    BorderMeasure measure;
    measure.narrowing = narrowing(saddle, Among::walls, walks);
    if (!is_cluttered(pair)) {
        measure.free_narrowing = measure.narrowing;
    } else if (free_saddle.clearance_m > 0.0F) {
        const bool is_same = free_saddle.a == saddle.a && free_saddle.b == saddle.b;
        measure.free_narrowing =
            narrowing(free_saddle, Among::all, is_same ? walks : walk_from(free_saddle));
    }
    describe(pair, num_openings(pair.first), num_openings(pair.second), measure);
    return measure;
}

void RegionGraph::describe_all(const Executor& executor) {
    parallel_for(executor, extent_.size(), kShapesPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i) {
                         if (!extent_[i].is_described) describe(extent_[i]);
                     }
                 });
}

void RegionGraph::describe(Extent& extent) const {
    extent.hull = hull_of(std::move(extent.corners));
    extent.corners = extent.hull.corners;
    extent.shape = shape_of(extent, extent.hull);
    extent.is_described = true;
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
    shape.open_share = extent.num_unknown / std::max(1.0, extent.num_unknown + extent.num_occupied);
    return shape;
}

std::array<double, 2> RegionGraph::open_in_line_m(const RegionPair& pair, const Opening& opening,
                                                  const Raster<float>& clearance) const {
    std::array<double, 2> open_m{};
    if (!opening.has_jambs) return open_m;
    for (std::size_t k = 0; k < 2; ++k) {
        const double sign = k == 0 ? -1.0 : 1.0;
        for (double t = 1.0; t <= kLineM / ground_.resolution_m; t += 1.0) {
            const Cell cell{opening.jambs[k].x + static_cast<std::int32_t>(
                                                     std::floor(0.5 + sign * t * opening.along.x)),
                            opening.jambs[k].y + static_cast<std::int32_t>(
                                                     std::floor(0.5 + sign * t * opening.along.y))};
            if (!pieces_.contains(cell)) break;
            const std::uint32_t region = region_[pieces_.at(cell)];
            const bool is_of_both = region != 0 && (region == pair.first || region == pair.second);
            if (is_of_both && clearance.at(cell) > 0.0F) open_m[k] += ground_.resolution_m;
        }
    }
    if (open_m[0] > open_m[1]) std::swap(open_m[0], open_m[1]);
    return open_m;
}

void RegionGraph::describe(const RegionPair& pair, const NumOpenings& openings_a,
                           const NumOpenings& openings_b, BorderMeasure& measure) const {
    const auto [a, b] = pair;
    Narrowing& free = measure.free_narrowing;
    if (free.is_a_narrower != measure.narrowing.is_a_narrower) {
        free.is_a_narrower = measure.narrowing.is_a_narrower;
        std::swap(free.narrower, free.wider);
    }
    const auto fill = [&](std::uint32_t region, const NumOpenings& openings, SideOfSaddle& side,
                          SideOfSaddle& free_side) {
        const Extent& extent = extent_[region];
        side.region_area_m2 = free_side.region_area_m2 = extent.area_m2;
        side.region_peak_m = extent.peak_m;
        free_side.region_peak_m = extent.free_peak_m;
        side.num_openings = openings[0];
        free_side.num_openings = openings[1];
    };
    const bool is_a_narrower = measure.narrowing.is_a_narrower;
    fill(is_a_narrower ? pair.first : pair.second, is_a_narrower ? openings_a : openings_b,
         measure.narrowing.narrower, free.narrower);
    fill(is_a_narrower ? pair.second : pair.first, is_a_narrower ? openings_b : openings_a,
         measure.narrowing.wider, free.wider);
    const std::uint32_t narrower = measure.narrowing.is_a_narrower ? a : b;
    const std::uint32_t wider = measure.narrowing.is_a_narrower ? b : a;
    measure.narrower = extent_[narrower].shape;
    measure.wider = extent_[wider].shape;
    Sums both = extent_[a];
    both.add(extent_[b]);
    measure.joined = shape_of(both, hull_of(extent_[a].hull, extent_[b].hull));
    measure.open_in_line_m = open_in_line_m(pair, measure.narrowing.opening, ground_.clearance_m);
    measure.free_in_line_m = open_in_line_m(pair, free.opening, ground_.free_clearance_m);
}

}  // namespace quadcut
