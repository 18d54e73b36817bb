// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/region_graph.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "quadcut/map/morton.hpp"
#include "quadcut/rooms/contacts.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

Saddle turned(const Saddle& saddle) {
    return {saddle.b, saddle.a, saddle.clearance_m, saddle.num_contacts};
}

/// Whether the wider of two saddles to the same region is the new one.
template <typename Key>
bool widen(std::map<Key, Saddle>& saddles, const Key& key, const Saddle& saddle) {
    const auto [at, is_first] = saddles.emplace(key, saddle);
    if (is_first) return true;
    const bool is_wider = saddle.clearance_m > at->second.clearance_m;
    const std::size_t num_contacts = at->second.num_contacts + saddle.num_contacts;
    if (is_wider) at->second = saddle;
    at->second.num_contacts = num_contacts;
    return is_wider;
}

BorderSaddles border_saddles(const Raster<std::uint32_t>& pieces, const Raster<float>& clearance_m,
                             const Executor& executor) {
    const std::vector<BorderSaddles> parts = for_each_contact<BorderSaddles>(
        pieces, executor, [&](Saddle& saddle, const Contact& contact) {
            const float height = std::min(clearance_m.at(contact.a), clearance_m.at(contact.b));
            if (saddle.num_contacts == 0 || height > saddle.clearance_m) {
                saddle = {contact.a, contact.b, height, saddle.num_contacts};
            }
            ++saddle.num_contacts;
        });
    BorderSaddles all;
    for (const BorderSaddles& part : parts) {
        for (const auto& [pair, saddle] : part) widen(all, pair, saddle);
    }
    return all;
}

}  // namespace

RegionGraph::RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                         const Raster<float>& clearance_m, double resolution_m,
                         const Executor& executor)
    : RegionGraph(pieces, num_pieces, border_saddles(pieces, clearance_m, executor), clearance_m,
                  resolution_m, executor) {}

RegionGraph::RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                         const BorderSaddles& saddles, const Raster<float>& clearance_m,
                         double resolution_m, const Executor& executor)
    : pieces_(pieces),
      clearance_(clearance_m),
      resolution_m_(resolution_m),
      region_(num_pieces + 1),
      members_(num_pieces + 1),
      extent_(num_pieces + 1),
      version_(num_pieces + 1, 0),
      saddles_(num_pieces + 1) {
    std::iota(region_.begin(), region_.end(), 0U);
    for (std::uint32_t piece = 1; piece <= num_pieces; ++piece) members_[piece] = {piece};
    const auto extents = tally_by_label<Extent>(
        pieces, executor,
        [&](Extent& extent, const LabelRun& run) {
            const auto num_cells = static_cast<double>(run.num_cells);
            extent.num_cells += num_cells;
            extent.sum_x += num_cells * (static_cast<double>(run.x) + 0.5 * (num_cells - 1.0));
            extent.sum_y += num_cells * static_cast<double>(run.y);
            extent.peak_m = static_cast<double>(largest(
                &clearance_m.values[run.offset], run.num_cells, static_cast<float>(extent.peak_m)));
        },
        [](Extent& extent, const Extent& other) {
            extent.num_cells += other.num_cells;
            extent.sum_x += other.sum_x;
            extent.sum_y += other.sum_y;
            extent.peak_m = std::max(extent.peak_m, other.peak_m);
        });
    std::copy(extents.begin(), extents.end(), extent_.begin());
    for (Extent& extent : extent_) extent.area_m2 = extent.num_cells * resolution_m * resolution_m;
    for (const auto& [pair, saddle] : saddles) {
        saddles_[pair.first].emplace(pair.second, saddle);
        saddles_[pair.second].emplace(pair.first, turned(saddle));
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
    if (watcher_) watcher_(a, b);
    for (const auto& [other, saddle] : saddles_[a]) forget_if_met(a, other, b);
    for (const auto& [other, saddle] : saddles_[b]) forget_if_met(b, other, a);
    for (const std::uint32_t piece : members_[b]) region_[piece] = a;
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    members_[b].clear();
    extent_[a].area_m2 += extent_[b].area_m2;
    extent_[a].peak_m = std::max(extent_[a].peak_m, extent_[b].peak_m);
    extent_[a].num_openings += extent_[b].num_openings;
    extent_[a].num_cells += extent_[b].num_cells;
    extent_[a].sum_x += extent_[b].sum_x;
    extent_[a].sum_y += extent_[b].sum_y;
    ++version_[a];
    saddles_[a].erase(b);
    measured_.erase(pair_of(a, b));
    for (const auto& [other, saddle] : saddles_[b]) {
        saddles_[other].erase(b);
        auto measured = measured_.extract(pair_of(b, other));
        if (other == a) continue;
        widen(saddles_[other], a, turned(saddle));
        if (!widen(saddles_[a], other, saddle)) continue;
        measured_.erase(pair_of(a, other));
        // Seen from the other side an opening may have other jambs.
        if (measured.empty() || (a < other) != (b < other)) continue;
        measured.key() = pair_of(a, other);
        measured_.insert(std::move(measured));
    }
    saddles_[b].clear();
}

/// What was measured in region `own`, at its saddle to `other`, before another one joins it.
void RegionGraph::forget_if_met(std::uint32_t own, std::uint32_t other, std::uint32_t joined) {
    const auto found = measured_.find(pair_of(own, other));
    if (found == measured_.end()) return;
    std::optional<WalkedSide>& side = found->second.sides[own < other ? 0 : 1];
    if (side && std::any_of(side->met.begin(), side->met.end(),
                            [&](std::uint32_t region) { return region_[region] == joined; })) {
        side.reset();
    }
}

void RegionGraph::complete(const Saddle& saddle, Measured& measured, NarrowingGauge& gauge) const {
    if (!measured.opening) measured.opening = measure_opening(clearance_, resolution_m_, saddle);
    const auto walk = [&](Cell seed, std::optional<WalkedSide>& side) {
        if (!side) side = gauge.walk_outward(seed, measured.opening->along, {pieces_, region_});
    };
    walk(saddle.a, measured.sides[0]);
    walk(saddle.b, measured.sides[1]);
}

Narrowing RegionGraph::measure(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const Saddle& saddle = saddles_[a].at(b);
    Measured& measured = measured_[{a, b}];
    if (gauges_.empty()) gauges_.emplace_back(clearance_, resolution_m_);
    complete(saddle, measured, gauges_.front());
    Narrowing narrowing = put_together(saddle, *measured.opening, measured.sides[0]->side,
                                       measured.sides[1]->side, resolution_m_);
    describe(a, b, narrowing);
    return narrowing;
}

void RegionGraph::collect_unmeasured(std::uint32_t region, double max_width_m, bool is_each_once,
                                     std::vector<Unmeasured>& found) {
    for (const auto& [other, saddle] : saddles_[region]) {
        if (2.0 * static_cast<double>(saddle.clearance_m) > max_width_m) continue;
        if (is_each_once && other < region) continue;
        const auto [a, b] = pair_of(region, other);
        Measured& measured = measured_[{a, b}];
        if (measured.opening && measured.sides[0] && measured.sides[1]) continue;
        found.push_back({&saddles_[a].at(b), &measured});
    }
}

void RegionGraph::measure(std::span<const Unmeasured> saddles, const Executor& executor) {
    // A gauge for each thread. Some saddles need far longer than others: one is taken at a time.
    const std::size_t num_parts =
        std::min(saddles.size(), static_cast<std::size_t>(std::max(1, executor.num_threads)));
    while (gauges_.size() < num_parts) gauges_.emplace_back(clearance_, resolution_m_);
    std::atomic<std::size_t> next = 0;
    parallel_for(executor, num_parts, 1, [&](std::size_t part, std::size_t) {
        for (std::size_t i = next++; i < saddles.size(); i = next++) {
            complete(*saddles[i].saddle, *saddles[i].measured, gauges_[part]);
        }
    });
}

void RegionGraph::measure_around(std::uint32_t region, double max_width_m,
                                 const Executor& executor) {
    std::vector<Unmeasured> saddles;
    collect_unmeasured(region, max_width_m, false, saddles);
    measure(saddles, executor);
}

void RegionGraph::measure_all(double max_width_m, const Executor& executor) {
    std::vector<Unmeasured> saddles;
    for (std::uint32_t region = 0; region < saddles_.size(); ++region) {
        collect_unmeasured(region, max_width_m, true, saddles);
    }
    const auto block = [box = pieces_.box()](const Unmeasured& unmeasured) {
        return block_code(unmeasured.saddle->a, box);
    };
    std::sort(saddles.begin(), saddles.end(),
              [&](const Unmeasured& p, const Unmeasured& q) { return block(p) < block(q); });
    measure(saddles, executor);
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

}  // namespace quadcut
