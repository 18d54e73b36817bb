// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/region_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace quadcut {
namespace {

/// A robot fits through an opening with this clearance.
constexpr float kFitsM = 0.25F;
/// What is smaller is not somewhere to go to.
constexpr double kPlaceM2 = 2.0;
constexpr std::size_t kSaddlesPerChunk = 64;

std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

}  // namespace

RegionGraph::RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                         const Raster<float>& clearance_m, double resolution_m)
    : pieces_(pieces),
      clearance_(clearance_m),
      resolution_m_(resolution_m),
      gauge_(clearance_m, resolution_m),
      region_(num_pieces + 1),
      members_(num_pieces + 1),
      extent_(num_pieces + 1),
      version_(num_pieces + 1, 0),
      saddles_(num_pieces + 1) {
    std::iota(region_.begin(), region_.end(), 0U);
    for (std::uint32_t piece = 1; piece <= num_pieces; ++piece) members_[piece] = {piece};
    const auto width = static_cast<std::size_t>(pieces.width);
    const auto is_border = [&](std::uint32_t piece, std::size_t other) {
        return pieces.values[other] != piece && pieces.values[other] != 0;
    };
    Cell cell = pieces.origin;
    for (std::size_t row = 0; row < pieces.values.size(); row += width, ++cell.y) {
        cell.x = pieces.origin.x;
        for (std::size_t i = row; i < row + width; ++i, ++cell.x) {
            const std::uint32_t piece = pieces.values[i];
            if (piece == 0) continue;
            Extent& extent = extent_[piece];
            extent.area_m2 += resolution_m * resolution_m;
            extent.peak_m = std::max(extent.peak_m, static_cast<double>(clearance_m.values[i]));
            extent.box.include({cell, cell});
            if (i + 1 < row + width && is_border(piece, i + 1)) meet(cell, {cell.x + 1, cell.y});
            if (row + width < pieces.values.size() && is_border(piece, i + width)) {
                meet(cell, {cell.x, cell.y + 1});
            }
        }
    }
}

void RegionGraph::add_beyond(std::uint32_t piece, const Beyond& beyond) {
    extent_[piece].area_m2 += beyond.area_m2;
    extent_[piece].peak_m = std::max(extent_[piece].peak_m, beyond.peak_m);
    extent_[piece].num_openings += beyond.num_openings;
}

std::size_t RegionGraph::num_saddles() const {
    std::size_t num_sides = 0;
    for (const auto& saddles : saddles_) num_sides += saddles.size();
    return num_sides / 2;
}

void RegionGraph::join(std::uint32_t a, std::uint32_t b) {
    for (const auto& [other, saddle] : saddles_[a]) {
        if (is_near(extent_[b].box, saddle)) measured_.erase(pair_of(a, other));
    }
    for (const std::uint32_t piece : members_[b]) region_[piece] = a;
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    members_[b].clear();
    extent_[a].area_m2 += extent_[b].area_m2;
    extent_[a].peak_m = std::max(extent_[a].peak_m, extent_[b].peak_m);
    extent_[a].num_openings += extent_[b].num_openings;
    extent_[a].box.include(extent_[b].box);
    ++version_[a];
    saddles_[a].erase(b);
    for (const auto& [other, saddle] : saddles_[b]) {
        saddles_[other].erase(b);
        measured_.erase(pair_of(b, other));
        if (other == a) continue;
        measured_.erase(pair_of(a, other));
        widen(saddles_[a], other, saddle);
        widen(saddles_[other], a, {saddle.b, saddle.a, saddle.clearance_m, saddle.num_contacts});
    }
    saddles_[b].clear();
}

Narrowing RegionGraph::measure(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [at, is_new] = measured_.try_emplace({a, b});
    Narrowing& narrowing = at->second;
    if (is_new) narrowing = gauge_.measure(saddles_[a].at(b), {pieces_, region_});
    describe(a, b, narrowing);
    return narrowing;
}

void RegionGraph::measure_all(double max_width_m, const Executor& executor) {
    struct Task {
        std::pair<std::uint32_t, std::uint32_t> pair;
        const Saddle* saddle = nullptr;
        Narrowing narrowing;
    };
    std::vector<Task> tasks;
    for (std::uint32_t region = 0; region < saddles_.size(); ++region) {
        for (const auto& [other, saddle] : saddles_[region]) {
            if (other < region || measured_.count({region, other}) != 0) continue;
            if (2.0 * static_cast<double>(saddle.clearance_m) <= max_width_m)
                tasks.push_back({{region, other}, &saddle, {}});
        }
    }
    parallel_for(executor, tasks.size(), kSaddlesPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     NarrowingGauge gauge(clearance_, resolution_m_);
                     for (std::size_t i = first; i < last; ++i) {
                         tasks[i].narrowing = gauge.measure(*tasks[i].saddle, {pieces_, region_});
                     }
                 });
    for (const Task& task : tasks) measured_.emplace(task.pair, task.narrowing);
}

Narrowing RegionGraph::measure_at(const Saddle& saddle, std::uint32_t a, std::uint32_t b,
                                  NarrowingGauge& gauge) const {
    Narrowing narrowing = gauge.measure(saddle, {pieces_, region_});
    describe(a, b, narrowing);
    return narrowing;
}

/// What a join changes however far away it is.
void RegionGraph::describe(std::uint32_t a, std::uint32_t b, Narrowing& narrowing) const {
    const auto fill = [&](std::uint32_t region, SideOfSaddle& side) {
        side.region_area_m2 = extent_[region].area_m2;
        side.region_peak_m = extent_[region].peak_m;
        side.num_openings =
            extent_[region].num_openings +
            static_cast<std::size_t>(std::count_if(
                saddles_[region].begin(), saddles_[region].end(), [&](const auto& entry) {
                    return entry.second.clearance_m > kFitsM &&
                           extent_[entry.first].area_m2 >= kPlaceM2;
                }));
    };
    fill(narrowing.is_a_narrower ? a : b, narrowing.narrower);
    fill(narrowing.is_a_narrower ? b : a, narrowing.wider);
}

bool RegionGraph::is_near(const Box& box, const Saddle& saddle) const {
    const auto reach = static_cast<std::int32_t>(std::ceil(kNarrowingReachM / resolution_m_)) + 1;
    return saddle.a.x >= box.low.x - reach && saddle.a.x <= box.high.x + reach &&
           saddle.a.y >= box.low.y - reach && saddle.a.y <= box.high.y + reach;
}

void RegionGraph::widen(std::map<std::uint32_t, Saddle>& saddles, std::uint32_t other,
                        const Saddle& saddle) {
    const auto [at, is_new] = saddles.emplace(other, saddle);
    if (is_new) return;
    const std::size_t num_contacts = at->second.num_contacts + saddle.num_contacts;
    if (saddle.clearance_m > at->second.clearance_m) at->second = saddle;
    at->second.num_contacts = num_contacts;
}

void RegionGraph::meet(Cell cell_a, Cell cell_b) {
    const std::uint32_t a = pieces_.at(cell_a);
    const std::uint32_t b = pieces_.at(cell_b);
    const float height = std::min(clearance_.at(cell_a), clearance_.at(cell_b));
    widen(saddles_[a], b, {cell_a, cell_b, height, 1});
    widen(saddles_[b], a, {cell_b, cell_a, height, 1});
}

}  // namespace quadcut
