// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "reproduce/claim.hpp"

// What is measured for each figure, and the paper's statements on it as tests. Limits stand here
// and nowhere else, each with its reason; none is chosen by what we measure.
namespace quadcut::reproduce {

// What the paper prints.
inline constexpr double kPaperNodes = 795.0;
inline constexpr double kPaperEntries = 59462.0;
inline constexpr double kPaperDiaPercent = 0.47;
inline constexpr std::size_t kPaperInnerSubmaps = 5;
inline constexpr std::size_t kPaperHalfSubmaps = 4;
inline constexpr double kPaperWholeMs = 17300.0;
inline constexpr double kPaperLocalMs = 43.0;

/// Fig 4: the quadtree against the occupancy grid.
struct StorageNumbers {
    ByWorld build_ratio;
    ByWorld node_percent;
    ByWorld look_up_ratio;
    /// Nodes over cells: of the finest cells over that of the coarsest.
    double finest_over_coarsest = 0.0;
};
[[nodiscard]] std::vector<Claim> judge(const StorageNumbers& numbers);

/// Fig 6: the workplace's matrix over the dense one, percent.
struct MatrixNumbers {
    double entries_percent = 0.0;
    double csr_percent = 0.0;
    double dia_percent = 0.0;
};
[[nodiscard]] std::vector<Claim> judge(const MatrixNumbers& numbers);

/// Fig 7: the edges' time.
struct ThreadNumbers {
    std::size_t num_cores = 1;
    /// One thread's time over that of the best number.
    double speed_up = 0.0;
    /// The time of the most threads over that of the best number.
    double most_over_best = 0.0;
};
[[nodiscard]] std::vector<Claim> judge(const ThreadNumbers& numbers);

/// Fig 11: the workplace in the paper's own setting: two states, number by silhouette.
struct WorkplaceNumbers {
    double num_inner = 0.0;
    double num_outer = 0.0;
    /// Of the main area, without the outside, against the five rooms.
    double pq_percent = 0.0;
    /// The weight that leaves a submap, over that which leaves a true room.
    double coupling_ratio = 0.0;
};
[[nodiscard]] std::vector<Claim> judge(const WorkplaceNumbers& numbers);

/// Fig 12: followed against cut at once.
struct ExplorationNumbers {
    /// PQ, percent.
    ByWorld paper_like_batch;
    ByWorld rooms_like_batch;
    /// In all moments of the preset paper's strips: submaps that the robot's way does not cross.
    ByWorld num_uncrossed;
    /// Of the workplace at the end.
    double num_submaps = 0.0;
};
[[nodiscard]] std::vector<Claim> judge(const ExplorationNumbers& numbers);

/// Fig 13: what a scan reaches.
struct UpdateNumbers {
    /// Mean ps of the observations that cross the middle of the map; without worlds where none
    /// does.
    ByWorld ps_crossing;
    /// Scans with a ps of at most a quarter, percent.
    ByWorld percent_below;
    /// Nodes made anew by a scan, median, percent.
    ByWorld rebuilt_percent;
    /// A KD-tree's nodes over those that a scan makes anew in the quadtree, means.
    ByWorld tree_over_rebuilt;
    /// The time of building a KD-tree anew over that of a scan, medians.
    ByWorld tree_over_scan;
};
[[nodiscard]] std::vector<Claim> judge(const UpdateNumbers& numbers);

/// Fig 14: preset paper, basic and incremental. Growth is from the second to the last quarter.
struct GrowthNumbers {
    ByWorld basic_growth;
    ByWorld update_growth;
    /// An update over the whole map at the end, percent.
    ByWorld node_percent;
    ByWorld time_percent;
};
[[nodiscard]] std::vector<Claim> judge(const GrowthNumbers& numbers);

/// A figure of the preset `paper`, and of what the paper sets it against.
struct Against {
    double paper = 0.0;
    double other = 0.0;
};

/// Figs 15-17: told a number of submaps.
struct SubmapNumbers {
    std::size_t num_told = 0;
    double num_made = 0.0;
    /// The weight that leaves a submap, and that between submaps, percent; of k-means.
    Against coupling_percent;
    Against cut_percent;
    /// Regions on both sides of a wall; of k-means.
    Against num_broken;
    /// Of k-means.
    Against elapsed_ms;
    /// The largest region over the mean; of the Voronoi graph.
    Against imbalance;
    /// Leaves; cells of the Voronoi graph.
    Against num_units;
};
[[nodiscard]] std::vector<Claim> judge(const SubmapNumbers& numbers);

/// Fig 18: the Intel lab.
struct IntelNumbers {
    double whole_ms = 0.0;
    double local_ms = 0.0;
    /// Against the true rooms: the whole map at once; of k-means without a graph.
    Against pq_percent;
    double followed_pq_percent = 0.0;
    /// Borders that lie across open floor, percent of their length; of the preset `rooms`.
    Against open_border_percent;
};
[[nodiscard]] std::vector<Claim> judge(const IntelNumbers& numbers);

/// Figs 20-22: the laboratory.
struct LaboratoryNumbers {
    /// The submaps at half the way against the final ones there, PQ.
    double half_like_end_percent = 0.0;
    double num_half = 0.0;
    double pq_percent = 0.0;
    /// True rooms that are cut apart; of the preset `rooms`.
    Against num_cut;
};
[[nodiscard]] std::vector<Claim> judge(const LaboratoryNumbers& numbers);

}  // namespace quadcut::reproduce
