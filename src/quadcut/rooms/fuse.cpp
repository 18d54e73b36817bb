// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/fuse.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quadcut/rooms/door_model.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut {
namespace {

/// From granularity 0 to 1 the threshold falls by so much: the range in which rooms differ.
constexpr double kLogOddsOfGranularity = 12.0;
/// At the default granularity a cut needs somewhat more than even odds: in maps of few and noisy
/// scans much looks like a door that is none.
constexpr double kDefaultLogOdds = 0.6;
/// Below all log-odds of what is measured.
constexpr double kNoDoor = -100.0;
/// Above them.
constexpr double kWall = 100.0;
/// Where two rooms have been, the opening between may be so much wider.
constexpr double kWiderOfEarlier = 1.25;
constexpr std::size_t kBordersPerChunk = 4;

}  // namespace

double fuse_threshold(double granularity) {
    return kDefaultLogOdds + kLogOddsOfGranularity * (0.5 - granularity);
}

double granularity_from(double log_odds) {
    return 0.5 - (log_odds - kDefaultLogOdds) / kLogOddsOfGranularity;
}

Fuser::Fuser(RegionGraph& regions, double max_width_m, const Executor& executor,
             EarlierDecisions earlier)
    : regions_(regions),
      max_width_m_(max_width_m),
      executor_(executor),
      earlier_(std::move(earlier)) {
    for (std::uint32_t region = 1; region <= regions.num_pieces(); ++region) {
        for (const auto& [other, saddle] : regions.saddles(region)) {
            if (other > region) push(region, other);
        }
    }
}

void Fuser::push(std::uint32_t a, std::uint32_t b) {
    // A pair has the same place in the order from whichever side it is looked at.
    if (a > b) std::swap(a, b);
    Candidate candidate{kNoDoor, a, b, regions_.version(a), regions_.version(b)};
    const double width_m = 2.0 * static_cast<double>(regions_.saddles(a).at(b).clearance_m);
    const double earlier = earlier_.log_odds(regions_, a, b);
    if (width_m > max_width_m_ * (earlier > 0.0 ? kWiderOfEarlier : 1.0)) {
        queue_.push(candidate);
    } else if (width_m < kPassesNobodyM) {
        candidate.log_odds = kWall + earlier;
        queue_.push(candidate);
    } else {
        waiting_.push_back(
            {candidate, regions_.num_openings(a), regions_.num_openings(b), earlier});
    }
}

bool Fuser::is_current(const Candidate& candidate) const {
    return regions_.is_region(candidate.a) && regions_.is_region(candidate.b) &&
           regions_.version(candidate.a) == candidate.version_a &&
           regions_.version(candidate.b) == candidate.version_b;
}

void Fuser::measure_waiting() {
    std::erase_if(waiting_, [&](const Waiting& waiting) { return !is_current(waiting.candidate); });
    std::vector<RegionPair> pairs;
    for (const Waiting& waiting : waiting_) {
        pairs.emplace_back(waiting.candidate.a, waiting.candidate.b);
    }
    regions_.look_at(pairs, executor_);
    parallel_for(
        executor_, pairs.size(), kBordersPerChunk, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                Waiting& waiting = waiting_[i];
                waiting.candidate.log_odds =
                    waiting.earlier + door_log_odds(regions_.measured(pairs[i], waiting.openings_a,
                                                                      waiting.openings_b));
            }
        });
    for (const Waiting& waiting : waiting_) queue_.push(waiting.candidate);
    waiting_.clear();
}

void Fuser::fuse_below(double min_log_odds) {
    while (fuse_next_below(min_log_odds)) continue;
}

bool Fuser::fuse_next_below(double min_log_odds) {
    while (true) {
        if (queue_.empty() || queue_.top().log_odds > kNoDoor) measure_waiting();
        if (queue_.empty() || queue_.top().log_odds >= min_log_odds) return false;
        const Candidate top = queue_.top();
        queue_.pop();
        if (!is_current(top)) continue;
        const bool a_larger = regions_.area_m2(top.a) >= regions_.area_m2(top.b);
        const std::uint32_t heir = a_larger ? top.a : top.b;
        regions_.join(heir, a_larger ? top.b : top.a);
        for (const auto& [other, saddle] : regions_.saddles(heir)) push(heir, other);
        return true;
    }
}

void fuse_small_regions(RegionGraph& regions, double min_area_m2, double min_width_m,
                        EarlierDecisions earlier) {
    const auto is_small = [&](std::uint32_t region) {
        return regions.area_m2(region) < min_area_m2 || 2.0 * regions.peak_m(region) < min_width_m;
    };
    std::vector<std::uint32_t> small;
    for (std::uint32_t region = 1; region <= regions.num_pieces(); ++region) {
        if (regions.is_region(region) && is_small(region)) small.push_back(region);
    }
    std::stable_sort(small.begin(), small.end(), [&](std::uint32_t p, std::uint32_t q) {
        return regions.area_m2(p) < regions.area_m2(q);
    });
    for (const std::uint32_t region : small) {
        if (!regions.is_region(region) || !is_small(region)) continue;
        const auto& saddles = regions.saddles(region);
        const auto rank = [&](const auto& neighbour) {
            return std::pair(earlier.log_odds(regions, region, neighbour.first) <= 0.0,
                             neighbour.second.clearance_m);
        };
        const auto widest =
            std::max_element(saddles.begin(), saddles.end(),
                             [&](const auto& p, const auto& q) { return rank(p) < rank(q); });
        if (widest != saddles.end()) regions.join(widest->first, region);
    }
}

std::map<std::uint32_t, std::uint32_t> enclosing_regions(const RegionGraph& regions,
                                                         std::span<const Enclosure> enclosures) {
    std::map<std::uint32_t, std::uint32_t> host_of;
    for (const Enclosure& enclosure : enclosures) {
        const std::uint32_t pocket = regions.region_of(enclosure.pocket);
        const std::uint32_t host = regions.region_of(enclosure.around.front());
        const bool is_one =
            std::all_of(enclosure.around.begin(), enclosure.around.end(),
                        [&](std::uint32_t region) { return regions.region_of(region) == host; });
        if (is_one && host != pocket && regions.area_m2(host) > 2.0 * regions.area_m2(pocket)) {
            host_of.emplace(pocket, host);
        }
    }
    return host_of;
}

std::vector<std::uint32_t> regions_of_pieces(const RegionGraph& regions) {
    std::vector<std::uint32_t> result(regions.num_pieces() + std::size_t{1}, 0);
    for (std::uint32_t piece = 1; piece < result.size(); ++piece) {
        result[piece] = regions.region_of(piece);
    }
    return result;
}

void relabel(const RegionGraph& regions, Raster<std::uint32_t>& labels,
             std::span<const Enclosure> enclosures, const Executor& executor) {
    std::vector<std::uint32_t> now = regions_of_pieces(regions);
    const auto host_of = enclosing_regions(regions, enclosures);
    for (std::uint32_t& region : now) {
        const auto found = host_of.find(region);
        if (found != host_of.end()) region = found->second;
    }
    renumber(labels, now, executor);
}

}  // namespace quadcut
