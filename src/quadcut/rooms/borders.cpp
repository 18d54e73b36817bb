// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/borders.hpp"

#include <algorithm>

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

/// What is narrower passes nobody, not even a leg: such places, as between the posts of a wall, do
/// not make a border longer.
constexpr float kSlitM = 0.08F;

}  // namespace

void add_contact(const Contact& contact, const Raster<float>& clearance_m, const WallLines& lines,
                 Saddle& saddle) {
    const float height = std::min(clearance_m.at(contact.a), clearance_m.at(contact.b));
    if (height > saddle.clearance_m) move_to({contact.a, contact.b, height}, saddle);
    if (height < kSlitM) return;
    ++saddle.num_contacts;
    if (lines.more_dm.values.empty()) return;
    const bool is_at_a = lines.more_dm.at(contact.a) >= lines.more_dm.at(contact.b);
    const Cell cell = is_at_a ? contact.a : contact.b;
    if (lines.more_dm.at(cell) == 0) return;
    ++saddle.num_in_line;
    saddle.less_wall_dm += lines.less_dm.at(cell);
    saddle.more_wall_dm += lines.more_dm.at(cell);
}

std::array<BorderSaddles, 2> border_saddles(const Raster<std::uint32_t>& pieces,
                                            const Raster<float>& clearance_m,
                                            const Raster<float>& free_clearance_m,
                                            const WallLines& lines, const Executor& executor) {
    using Both = std::array<Saddle, 2>;
    const auto parts = for_each_contact<std::map<std::pair<std::uint32_t, std::uint32_t>, Both>>(
        pieces, executor, [&](Both& saddles, const Contact& contact) {
            add_contact(contact, clearance_m, lines, saddles[0]);
            add_contact(contact, free_clearance_m, lines, saddles[1]);
        });
    std::array<BorderSaddles, 2> all;
    for (const auto& part : parts) {
        for (const auto& [pair, saddles] : part) {
            for (std::size_t k = 0; k < all.size(); ++k) {
                if (saddles[k].clearance_m > 0.0F) widen(all[k], pair, saddles[k]);
            }
        }
    }
    return all;
}

Borders::Borders(const BorderSaddles& saddles, std::uint32_t num_pieces)
    : saddles_(num_pieces + std::size_t{1}) {
    for (const auto& [pair, saddle] : saddles) {
        saddles_[pair.first].emplace(pair.second, saddle);
        saddles_[pair.second].emplace(pair.first, turned(saddle));
    }
}

const Saddle* Borders::find(std::uint32_t a, std::uint32_t b) const {
    const auto found = saddles_[a].find(b);
    return found == saddles_[a].end() ? nullptr : &found->second;
}

std::pair<Opening*, bool> Borders::place_for_opening(std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = openings_.try_emplace({a, b});
    return {&at->second, is_new};
}

void Borders::join(std::uint32_t a, std::uint32_t b) {
    saddles_[a].erase(b);
    openings_.erase(pair_of(a, b));
    for (const auto& [other, saddle] : saddles_[b]) {
        saddles_[other].erase(b);
        auto opening = openings_.extract(pair_of(b, other));
        if (other == a) continue;
        widen(saddles_[other], a, turned(saddle));
        if (!widen(saddles_[a], other, saddle)) continue;
        openings_.erase(pair_of(a, other));
        // Seen from the other side an opening may have other jambs.
        if (opening.empty() || (a < other) != (b < other)) continue;
        opening.key() = pair_of(a, other);
        openings_.insert(std::move(opening));
    }
    saddles_[b].clear();
}

std::pair<WalkedSide*, bool> Walks::place_for(std::uint32_t region, std::size_t seed) {
    const auto [at, is_new] = walks_[region].try_emplace(seed);
    return {&at->second, is_new};
}

void Walks::join(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> region_of_piece) {
    const auto forget_those_at = [&](std::uint32_t other, std::map<std::size_t, WalkedSide>& own) {
        std::erase_if(own, [&](const auto& walk) {
            const std::vector<std::uint32_t>& met = walk.second.met;
            return std::any_of(met.begin(), met.end(), [&](std::uint32_t piece) {
                return region_of_piece[piece] == other;
            });
        });
    };
    forget_those_at(b, walks_[a]);
    forget_those_at(a, walks_[b]);
    walks_[a].merge(walks_[b]);
    walks_[b].clear();
}

}  // namespace quadcut
