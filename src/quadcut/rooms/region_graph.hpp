// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/borders.hpp"
#include "quadcut/rooms/hull.hpp"
#include "quadcut/rooms/label_tally.hpp"
#include "quadcut/rooms/narrowing.hpp"

namespace quadcut {

/// A robot fits through an opening with this clearance.
inline constexpr float kFitsM = 0.25F;
/// What is narrower than this among walls passes nobody: it is a wall that was seen in pieces.
inline constexpr double kPassesNobodyM = 0.25;
/// What is smaller is not somewhere to go to.
inline constexpr double kPlaceM2 = 2.0;

/// What a room, or a part of it, has outside of a window of the map.
struct Beyond {
    double area_m2 = 0.0;
    /// The largest clearance.
    double peak_m = 0.0;
    /// To rooms that are somewhere to go to.
    std::size_t num_openings = 0;
};

/// The floor that regions are made of; rasters of one rectangle that outlive what looks at them.
struct Ground {
    /// The clearance among walls: furniture is open.
    const Raster<float>& clearance_m;
    /// The clearance among all obstacles.
    const Raster<float>& free_clearance_m;
    const Raster<CellState>& states;
    /// Empty: none are known.
    const WallLines& lines;
    double resolution_m = 0.05;
};

/// How a region fills what is around it.
struct RegionShape {
    double area_m2 = 0.0;
    /// A quarter of the width, in a corridor.
    double mean_clearance_m = 0.0;
    double mean_free_clearance_m = 0.0;
    /// Of its convex hull.
    double hull_m2 = 0.0;
    /// The smallest rectangle around it.
    Rectangle around_m;
    /// The share of its border that is open to the unknown.
    double open_share = 0.0;
};

/// What is known about a border between two regions.
struct BorderMeasure {
    /// Among walls, and among all obstacles, where that may differ; the latter all 0 where nothing
    /// is free between them.
    Narrowing narrowing;
    Narrowing free_narrowing;
    /// Of the narrower side, the wider, and both together.
    RegionShape narrower;
    RegionShape wider;
    RegionShape joined;
    /// In line with the opening, beyond each jamb: metres that are open in one of the two regions.
    /// Smaller one first.
    std::array<double, 2> open_in_line_m{};
    std::array<double, 2> free_in_line_m{};
};

/// The openings of a region that a robot fits through, to what is somewhere to go to: among walls,
/// and among all obstacles.
using NumOpenings = std::array<std::size_t, 2>;

/// Two regions a < b that touch.
using RegionPair = std::pair<std::uint32_t, std::uint32_t>;

/// Regions made of pieces that only ever join, with the widest saddle to each neighbour.
class RegionGraph {
public:
    /// One region a piece (labels 1 .. num_pieces). The rasters must outlive the graph. O(cells).
    RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces, const Ground& ground,
                const Executor& executor = {});

    /// The region that a piece has become part of; a region is named by one of its pieces.
    [[nodiscard]] std::uint32_t region_of(std::uint32_t piece) const { return region_[piece]; }
    [[nodiscard]] bool is_region(std::uint32_t piece) const { return region_[piece] == piece; }
    /// The pieces of a region.
    [[nodiscard]] std::span<const std::uint32_t> members(std::uint32_t region) const {
        return members_[region];
    }
    [[nodiscard]] std::uint32_t num_pieces() const {
        return static_cast<std::uint32_t>(region_.size() - 1);
    }
    /// The number of pairs of regions that touch. O(regions).
    [[nodiscard]] std::size_t num_saddles() const;
    /// The regions that touch this one, and where they are widest apart from it.
    [[nodiscard]] const std::map<std::uint32_t, Saddle>& saddles(std::uint32_t region) const {
        return borders_[0].of(region);
    }
    [[nodiscard]] double area_m2(std::uint32_t region) const { return extent_[region].area_m2; }
    /// The largest clearance in the region.
    [[nodiscard]] double peak_m(std::uint32_t region) const { return extent_[region].peak_m; }
    /// The mean place of the region's cells, in cells of the raster.
    [[nodiscard]] Point centroid(std::uint32_t region) const {
        const Extent& extent = extent_[region];
        return {extent.sum_x / extent.num_cells, extent.sum_y / extent.num_cells};
    }
    /// How often the region has been joined with another.
    [[nodiscard]] std::uint32_t version(std::uint32_t region) const { return version_[region]; }

    /// What a piece has beyond the raster, of which it is a part. @pre nothing was joined yet.
    void add_beyond(std::uint32_t piece, const Beyond& beyond);

    /// Told of each join while both regions are there still: for whoever notes decisions.
    void watch_joins(std::function<void(std::uint32_t a, std::uint32_t b)> watcher) {
        watcher_ = std::move(watcher);
    }
    /// Joins b into a; the saddles of both to a third region become the wider of the two.
    void join(std::uint32_t a, std::uint32_t b);

    [[nodiscard]] NumOpenings num_openings(std::uint32_t region) const;

    /// What lies on both sides of the saddle between two regions that touch. What a join has not
    /// come near to is not measured again.
    [[nodiscard]] BorderMeasure measure(std::uint32_t a, std::uint32_t b);
    /// Looks ahead at what measured() is going to need, on all threads.
    void look_at(std::span<const RegionPair> pairs, const Executor& executor);
    /// The same as measure() of a < b, with the openings that each has or had.
    /// @pre Was looked at, and neither region was joined since.
    [[nodiscard]] BorderMeasure measured(const RegionPair& pair, const NumOpenings& openings_a,
                                         const NumOpenings& openings_b) const;
    /// The same as measure() at other saddles between them, whose cell a lies in region a.
    /// @pre Both regions were described.
    [[nodiscard]] BorderMeasure measure_at(const Saddle& saddle, const Saddle& free_saddle,
                                           const RegionPair& pair, NarrowingGauge& gauge) const;
    void describe_all(const Executor& executor);
    [[nodiscard]] NarrowingGauge gauge() const {
        return {ground_.clearance_m, ground_.free_clearance_m, ground_.resolution_m};
    }

private:
    /// Over the raster's cells.
    struct Sums {
        /// All but the clearances are whole numbers: their sums are exact in any order.
        double num_cells = 0.0;
        double sum_x = 0.0;
        double sum_y = 0.0;
        double sum_clearance_m = 0.0;
        double sum_free_clearance_m = 0.0;
        /// Sides of cells towards the unknown and towards obstacles.
        double num_unknown = 0.0;
        double num_occupied = 0.0;

        void add(const Sums& other);
    };
    struct Extent : Sums {
        double area_m2 = 0.0;
        double peak_m = 0.0;
        double free_peak_m = 0.0;
        /// Openings beyond the raster.
        std::size_t num_openings = 0;
        /// Whether there is furniture that makes the clearance another.
        bool is_cluttered = false;
        /// The hull's, and perhaps more.
        std::vector<Point> corners;
        /// Whether these two are made, and as the region is now.
        bool is_described = false;
        Hull hull;
        RegionShape shape;

        void add(const Extent& other);
    };

    /// What is still to be measured, and where it goes.
    struct Unseen {
        std::vector<std::tuple<Among, const Saddle*, Opening*>> openings;
        std::vector<std::pair<Cell, WalkedSide*>> walks;
        std::vector<Extent*> shapes;
    };

    [[nodiscard]] RegionsView view() const { return {pieces_, region_}; }
    [[nodiscard]] const Raster<float>& clearance(Among obstacles) const {
        return obstacles == Among::walls ? ground_.clearance_m : ground_.free_clearance_m;
    }
    /// The sides of a run's cells towards what is in no piece.
    void add_sides(const LabelRun& run, Sums& sums) const;
    void describe(Extent& extent) const;
    [[nodiscard]] RegionShape shape_of(const Sums& extent, const Hull& hull) const;
    /// Whether furniture makes the clearance another.
    [[nodiscard]] bool is_cluttered(const RegionPair& pair) const {
        return extent_[pair.first].is_cluttered || extent_[pair.second].is_cluttered;
    }
    void collect_unseen(const RegionPair& pair, Among obstacles, Unseen& unseen);
    [[nodiscard]] Narrowing narrowing_of(const RegionPair& pair, Among obstacles) const;
    /// What a join changes however far away it is.
    void describe(const RegionPair& pair, const NumOpenings& openings_a,
                  const NumOpenings& openings_b, BorderMeasure& measure) const;
    [[nodiscard]] std::array<double, 2> open_in_line_m(const RegionPair& pair,
                                                       const Opening& opening,
                                                       const Raster<float>& clearance) const;

    std::function<void(std::uint32_t a, std::uint32_t b)> watcher_;
    const Raster<std::uint32_t>& pieces_;
    Ground ground_;
    std::vector<std::uint32_t> region_;
    std::vector<std::vector<std::uint32_t>> members_;
    std::vector<Extent> extent_;
    std::vector<std::uint32_t> version_;
    /// Among walls, among all obstacles.
    std::vector<Borders> borders_;
    Walks walks_;
    /// One for each thread.
    std::vector<NarrowingGauge> gauges_;
};

}  // namespace quadcut
