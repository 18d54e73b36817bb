// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/borders.hpp"

#include <algorithm>
#include <atomic>

#include "quadcut/map/morton.hpp"
#include "quadcut/rooms/contacts.hpp"

namespace quadcut {
namespace {

std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

Saddle turned(const Saddle& saddle) {
    Saddle result = saddle;
    std::swap(result.a, result.b);
    return result;
}

void add_counts(const Saddle& from, Saddle& to) {
    to.num_contacts += from.num_contacts;
    to.num_in_line += from.num_in_line;
    to.less_wall_dm += from.less_wall_dm;
    to.more_wall_dm += from.more_wall_dm;
}

/// Another place of a saddle; the counts stay.
void move_to(const Saddle& place, Saddle& saddle) {
    saddle.a = place.a;
    saddle.b = place.b;
    saddle.clearance_m = place.clearance_m;
}

/// Whether the wider of two saddles to the same region is the new one.
template <typename Key>
bool widen(std::map<Key, Saddle>& saddles, const Key& key, const Saddle& saddle) {
    const auto [at, is_first] = saddles.emplace(key, saddle);
    if (is_first) return true;
    const bool is_wider = saddle.clearance_m > at->second.clearance_m;
    if (is_wider) move_to(saddle, at->second);
    add_counts(saddle, at->second);
    return is_wider;
}

}  // namespace

BorderSaddles border_saddles(const Raster<std::uint32_t>& pieces, const Raster<float>& clearance_m,
                             const WallLines& lines, const Executor& executor) {
    const std::vector<BorderSaddles> parts = for_each_contact<BorderSaddles>(
        pieces, executor, [&](Saddle& saddle, const Contact& contact) {
            const float height = std::min(clearance_m.at(contact.a), clearance_m.at(contact.b));
            if (saddle.num_contacts == 0 || height > saddle.clearance_m) {
                move_to({contact.a, contact.b, height}, saddle);
            }
            if (height <= 0.0F) return;
            ++saddle.num_contacts;
            if (lines.more_dm.values.empty()) return;
            const bool is_at_a = lines.more_dm.at(contact.a) >= lines.more_dm.at(contact.b);
            const Cell cell = is_at_a ? contact.a : contact.b;
            if (lines.more_dm.at(cell) == 0) return;
            ++saddle.num_in_line;
            saddle.less_wall_dm += lines.less_dm.at(cell);
            saddle.more_wall_dm += lines.more_dm.at(cell);
        });
    BorderSaddles all;
    for (const BorderSaddles& part : parts) {
        for (const auto& [pair, saddle] : part) {
            if (saddle.num_contacts > 0) widen(all, pair, saddle);
        }
    }
    return all;
}

Borders::Borders(const BorderSaddles& saddles, std::uint32_t num_pieces,
                 const Raster<float>& clearance_m, double resolution_m)
    : clearance_(clearance_m), resolution_m_(resolution_m), saddles_(num_pieces + 1) {
    for (const auto& [pair, saddle] : saddles) {
        saddles_[pair.first].emplace(pair.second, saddle);
        saddles_[pair.second].emplace(pair.first, turned(saddle));
    }
}

void Borders::join(std::uint32_t a, std::uint32_t b, const RegionsView& regions) {
    for (const auto& [other, saddle] : saddles_[a]) forget_if_met(a, other, b, regions);
    for (const auto& [other, saddle] : saddles_[b]) forget_if_met(b, other, a, regions);
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
void Borders::forget_if_met(std::uint32_t own, std::uint32_t other, std::uint32_t joined,
                            const RegionsView& regions) {
    const auto found = measured_.find(pair_of(own, other));
    if (found == measured_.end()) return;
    std::optional<WalkedSide>& side = found->second.sides[own < other ? 0 : 1];
    if (side && std::any_of(side->met.begin(), side->met.end(), [&](std::uint32_t region) {
            return regions.region_of_piece[region] == joined;
        })) {
        side.reset();
    }
}

void Borders::complete(const Saddle& saddle, const RegionsView& regions, Measured& measured,
                       NarrowingGauge& gauge) const {
    if (!measured.opening) measured.opening = measure_opening(clearance_, resolution_m_, saddle);
    const auto walk = [&](Cell seed, std::optional<WalkedSide>& side) {
        if (!side) side = gauge.walk_outward(seed, measured.opening->along, regions);
    };
    walk(saddle.a, measured.sides[0]);
    walk(saddle.b, measured.sides[1]);
}

std::optional<Narrowing> Borders::measure(std::uint32_t a, std::uint32_t b,
                                          const RegionsView& regions) {
    if (a > b) std::swap(a, b);
    const auto found = saddles_[a].find(b);
    if (found == saddles_[a].end()) return std::nullopt;
    Measured& measured = measured_[{a, b}];
    if (gauges_.empty()) gauges_.emplace_back(clearance_, resolution_m_);
    complete(found->second, regions, measured, gauges_.front());
    return put_together(found->second, *measured.opening, measured.sides[0]->side,
                        measured.sides[1]->side, resolution_m_);
}

void Borders::collect_unmeasured(std::uint32_t region, double max_width_m, bool is_each_once,
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

void Borders::measure(std::span<const Unmeasured> saddles, const RegionsView& regions,
                      const Executor& executor) {
    // A gauge for each thread. Some saddles need far longer than others: one is taken at a time.
    const std::size_t num_parts =
        std::min(saddles.size(), static_cast<std::size_t>(std::max(1, executor.num_threads)));
    while (gauges_.size() < num_parts) gauges_.emplace_back(clearance_, resolution_m_);
    std::atomic<std::size_t> next = 0;
    parallel_for(executor, num_parts, 1, [&](std::size_t part, std::size_t) {
        for (std::size_t i = next++; i < saddles.size(); i = next++) {
            complete(*saddles[i].saddle, regions, *saddles[i].measured, gauges_[part]);
        }
    });
}

void Borders::measure_around(std::uint32_t region, double max_width_m, const RegionsView& regions,
                             const Executor& executor) {
    std::vector<Unmeasured> saddles;
    collect_unmeasured(region, max_width_m, false, saddles);
    measure(saddles, regions, executor);
}

void Borders::measure_all(double max_width_m, const RegionsView& regions,
                          const Executor& executor) {
    std::vector<Unmeasured> saddles;
    for (std::uint32_t region = 0; region < saddles_.size(); ++region) {
        collect_unmeasured(region, max_width_m, true, saddles);
    }
    const auto block = [box = clearance_.box()](const Unmeasured& unmeasured) {
        return block_code(unmeasured.saddle->a, box);
    };
    std::sort(saddles.begin(), saddles.end(),
              [&](const Unmeasured& p, const Unmeasured& q) { return block(p) < block(q); });
    measure(saddles, regions, executor);
}

}  // namespace quadcut
