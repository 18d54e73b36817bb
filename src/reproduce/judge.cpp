// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/judge.hpp"

#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

constexpr double kPaperEntriesPercent = 100.0 * kPaperEntries / (kPaperNodes * kPaperNodes);
/// Compressed rows: 8 bytes a weight and 4 a column, where the dense matrix has 8 bytes.
constexpr double kCsrBytesRatio = 1.5;
/// How two people who drew the rooms of the Intel lab agree, PQ in percent.
constexpr double kPeopleAgreePercent = 77.0;
constexpr const char* kAsPeople = "two people who drew the rooms of the Intel lab agree as well";
/// What one method makes of the same scans, PQ in percent.
constexpr double kSameMethodPercent = 80.0;
constexpr const char* kSameMethod =
    "the same method on the same scans: above the 77 % at which two people agree";
constexpr const char* kAsCharts =
    "the paper's charts have the quadtree lower on all three data sets";

ByWorld one(double value) { return {{"", value}}; }

}  // namespace

std::vector<Claim> judge(const StorageNumbers& numbers) {
    return {
        {"time of construction, times the occupancy grid's", numbers.build_ratio, "", Bound::below,
         1.0, kAsCharts},
        {"nodes over the grid's cells", numbers.node_percent, "%", Bound::below, 100.0, kAsCharts},
        {"time of 10,000 look-ups, times the grid's", numbers.look_up_ratio, "", Bound::below, 1.0,
         kAsCharts},
        {"nodes over cells on the finest cells, times that on the coarsest",
         one(numbers.finest_over_coarsest), "", Bound::below, 1.0,
         "the higher the resolution, the larger the advantage"}};
}

std::vector<Claim> judge(const MatrixNumbers& numbers) {
    return {{"entries of the workplace's matrix", one(numbers.entries_percent), "%", Bound::at_most,
             kPaperEntriesPercent, "the paper's 59,462 entries of 795 x 795"},
            {"memory over the dense matrix's, compressed rows", one(numbers.csr_percent), "%",
             Bound::at_most, kCsrBytesRatio * kPaperEntriesPercent,
             "what the paper's entries take so, 12 bytes for each"},
            {"memory by diagonals, as the paper stores it", one(numbers.dia_percent), "%",
             Bound::at_most, kPaperDiaPercent,
             "the paper's figure, which its own number of entries contradicts"}};
}

std::vector<Claim> judge(const ThreadNumbers& numbers) {
    const double cores = static_cast<double>(numbers.num_cores);
    return {{"times as fast with the best number of threads as with one", one(numbers.speed_up), "",
             Bound::at_least, 0.5 * (1.0 + cores),
             "\"a lot of time\" is taken for half of what " + in_words(cores) +
                 (numbers.num_cores == 1 ? " core" : " cores") + " can give"},
            {"the most threads' time, times the best's", one(numbers.most_over_best), "",
             Bound::above, 1.05, "too many cost some: what is within 5 % is no difference"}};
}

std::vector<Claim> judge(const WorkplaceNumbers& numbers) {
    return {{"inner submaps, two states", one(numbers.num_inner), "", Bound::equal,
             kPaperInnerSubmaps, "Fig 11(d) has five, where the paper knows two states"},
            {"outer submaps, two states", one(numbers.num_outer), "", Bound::at_least, 2.0,
             "the exterior is divided into several"},
            {"PQ of the main area against the five rooms", one(numbers.pq_percent), "%",
             Bound::at_least, kPeopleAgreePercent, kAsPeople},
            {"edge weight that leaves an inner submap, times that of a true room",
             one(numbers.coupling_ratio), "", Bound::at_most, 1.5,
             "low coupling: rooms couple through their doors alone, and half as much again is a "
             "cut beside the door"}};
}

std::vector<Claim> judge(const ExplorationNumbers& numbers) {
    return {{"preset paper, followed against at once, PQ", numbers.paper_like_batch, "%",
             Bound::at_least, kSameMethodPercent, kSameMethod},
            {"preset rooms, followed against at once, PQ", numbers.rooms_like_batch, "%",
             Bound::at_least, kSameMethodPercent, kSameMethod},
            {"preset paper, submaps in the map that the way does not cross", numbers.num_uncrossed,
             "", Bound::equal, 0.0, "such a submap is invalid"},
            {"submaps of the workplace at the end", one(numbers.num_submaps), "", Bound::equal,
             kPaperInnerSubmaps, "as in Fig 11"}};
}

std::vector<Claim> judge(const UpdateNumbers& numbers) {
    return {{"ps when the observation crosses the middle", numbers.ps_crossing, "%",
             Bound::at_least, 99.9, "the paper: 100 %"},
            {"scans with a ps of at most 25 %", numbers.percent_below, "%", Bound::at_least, 50.0,
             "\"in most of the time\" is more often than not"},
            {"nodes rebuilt by a scan, median", numbers.rebuilt_percent, "%", Bound::at_most, 25.0,
             "less than a quarter is reconstructed"},
            {"nodes of the KD-tree, times those rebuilt", numbers.tree_over_rebuilt, "",
             Bound::above, 1.0, "the KD-tree reconstructs all"},
            {"time of a new KD-tree, times a scan's", numbers.tree_over_scan, "", Bound::above, 1.0,
             "what is rebuilt is what costs"}};
}

std::vector<Claim> judge(const GrowthNumbers& numbers) {
    constexpr double kStable = 1.25;
    constexpr const char* kHalf = "an update of half the map saves little";
    return {{"growth of the whole map's matrix", numbers.basic_growth, "", Bound::above, 1.0,
             "it increases over time"},
            {"growth of an update's matrix", numbers.update_growth, "", Bound::at_most, kStable,
             "stable: a quarter more at most"},
            {"nodes of an update over the whole map's, mean", numbers.node_percent, "%",
             Bound::at_most, 50.0, kHalf},
            {"time of an update over the whole map's, median", numbers.time_percent, "%",
             Bound::at_most, 50.0, kHalf}};
}

std::vector<Claim> judge(const SubmapNumbers& numbers) {
    return {{"submaps, told " + std::to_string(numbers.num_told), one(numbers.num_made), "",
             Bound::equal, static_cast<double>(numbers.num_told), "k is given"},
            {"edge weight that leaves a submap, mean", one(numbers.coupling_percent.paper), "%",
             Bound::below, numbers.coupling_percent.other,
             "low coupling: less than k-means has, which knows no edges"},
            {"edge weight between submaps, of all", one(numbers.cut_percent.paper), "%",
             Bound::below, numbers.cut_percent.other, "the same of the sum"},
            {"largest submap over the mean", one(numbers.imbalance.paper), "", Bound::below,
             numbers.imbalance.other, "balanced, where the Voronoi graph's units are irregular"},
            {"submaps on both sides of a wall", one(numbers.num_broken.paper), "", Bound::equal,
             0.0, "they follow the walls"},
            {"clusters of k-means on both sides of a wall", one(numbers.num_broken.other), "",
             Bound::at_least, 1.0, "k-means can hardly follow the walls"},
            {"time of k-means", one(numbers.elapsed_ms.other), "ms", Bound::below,
             numbers.elapsed_ms.paper, "it may be faster than the preset paper: no graph to make"},
            {"cells of the Voronoi graph", one(numbers.num_units.other), "", Bound::below,
             numbers.num_units.paper, "fewer map units than leaves of the quadtree"}};
}

std::vector<Claim> judge(const IntelNumbers& numbers) {
    return {{"the whole map", one(numbers.whole_ms), "ms", Bound::below, kPaperWholeMs,
             "the paper's time, on its machine"},
            {"a local segmentation of 150 nodes", one(numbers.local_ms), "ms", Bound::below,
             kPaperLocalMs, "the paper's time, on its machine"},
            {"local over whole", one(100.0 * numbers.local_ms / numbers.whole_ms), "%",
             Bound::at_most, 1.0, "the paper: 0.25 %; four times that is still \"a little time\""},
            {"PQ against the true rooms, whole map", one(numbers.pq_percent.paper), "%",
             Bound::at_least, kPeopleAgreePercent, std::string("\"correctness\": ") + kAsPeople},
            {"the same, followed", one(numbers.followed_pq_percent), "%", Bound::at_least,
             kPeopleAgreePercent, "\"the robot can maintain a segmented map in real time\""},
            {"PQ against the true rooms, whole map", one(numbers.pq_percent.paper), "%",
             Bound::above, numbers.pq_percent.other, "what k-means reaches without a graph"},
            {"borders across open floor", one(numbers.open_border_percent.paper), "%", Bound::above,
             numbers.open_border_percent.other,
             "admitted: corridors are cut by size, borders are no doors; limit: the preset rooms"}};
}

std::vector<Claim> judge(const LaboratoryNumbers& numbers) {
    return {{"submaps at half the way against the final ones there, PQ",
             one(numbers.half_like_end_percent), "%", Bound::at_least, kSameMethodPercent,
             "\"very similar\": above the 77 % at which two people agree"},
            {"submaps at half the way", one(numbers.num_half), "", Bound::at_least,
             static_cast<double>(kPaperHalfSubmaps), "the paper shows four on its floor"},
            {"PQ against the true rooms at the end", one(numbers.pq_percent), "%", Bound::at_least,
             kPeopleAgreePercent, std::string("\"fits the structure of the room\": ") + kAsPeople},
            {"true rooms cut apart", one(numbers.num_cut.paper), "", Bound::above,
             numbers.num_cut.other,
             "admitted: tables count as walls; the preset rooms takes them for furniture"}};
}

}  // namespace quadcut::reproduce
