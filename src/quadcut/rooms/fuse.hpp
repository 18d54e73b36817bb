// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <cstdlib>
#include <map>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/previous.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/rooms/regions.hpp"

namespace quadcut {

/// The log-odds below which cuts are fused, for a granularity of 0 (few rooms) .. 1 (many).
[[nodiscard]] double fuse_threshold(double granularity);
/// The granularity from which on a cut of such log-odds is kept; it may be beyond 0 .. 1.
[[nodiscard]] double granularity_from(double log_odds);

/// Joins regions: the least door-like cut goes first, and what is joined is measured anew.
class Fuser {
public:
    /// Openings that are wider than `max_width_m` separate nothing. `earlier` counts beside what is
    /// measured. The regions must outlive the fuser, and nothing else may join them while it is in
    /// use.
    Fuser(RegionGraph& regions, double max_width_m, const Executor& executor = {},
          EarlierDecisions earlier = {});

    /// Joins until every cut that is left has at least these log-odds of being a door. To stop
    /// halfway changes nothing: what is fused at one granularity is fused at every lower one.
    void fuse_below(double min_log_odds);
    /// One of these joins; whether there was one to make.
    bool fuse_next_below(double min_log_odds);

private:
    /// A saddle with the numbers of joins that its two regions had seen when it was measured.
    struct Candidate {
        double log_odds = 0.0;
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::uint32_t version_a = 0;
        std::uint32_t version_b = 0;
        /// Lowest first; ties by region, so that the order is the same everywhere.
        friend bool operator<(const Candidate& p, const Candidate& q) {
            return std::tie(p.log_odds, p.a, p.b) > std::tie(q.log_odds, q.a, q.b);
        }
    };

    /// What may have to be measured: only when all is joined that is too wide to be a door.
    struct Waiting {
        Candidate candidate;
        /// As they are when the candidate is found.
        NumOpenings openings_a{};
        NumOpenings openings_b{};
        /// What an earlier result adds to its log-odds.
        double earlier = 0.0;
    };

    void push(std::uint32_t a, std::uint32_t b);
    void measure_waiting();
    [[nodiscard]] bool is_current(const Candidate& candidate) const;

    RegionGraph& regions_;
    double max_width_m_;
    Executor executor_;
    EarlierDecisions earlier_;
    std::priority_queue<Candidate> queue_;
    std::vector<Waiting> waiting_;
};

/// Pieces of less are joined before anything is measured: most lie between legs and in corners.
inline const double kMinPieceM2 = std::getenv("MP") ? std::atof(std::getenv("MP")) : 0.5;

/// What is smaller than a room, or nowhere as wide as a robot, joins a neighbour through its widest
/// saddle, smallest first; if it can, one that it was not apart from earlier. What has no neighbour
/// stays.
void fuse_small_regions(RegionGraph& regions, double min_area_m2, double min_width_m,
                        EarlierDecisions earlier = {});

/// The regions that are no rooms of their own, and the region that each belongs to: of enclosures
/// that one region is all around of, if that has twice the area.
[[nodiscard]] std::map<std::uint32_t, std::uint32_t> enclosing_regions(
    const RegionGraph& regions, std::span<const Enclosure> enclosures);

/// By piece; nothing at 0, which is no piece.
[[nodiscard]] std::vector<std::uint32_t> regions_of_pieces(const RegionGraph& regions);

/// Each piece's cells get the number of its region, or of the one that encloses it.
void relabel(const RegionGraph& regions, Raster<std::uint32_t>& labels,
             std::span<const Enclosure> enclosures = {}, const Executor& executor = {});

}  // namespace quadcut
