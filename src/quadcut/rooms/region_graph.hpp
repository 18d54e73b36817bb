// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/narrowing.hpp"

namespace quadcut {

/// A robot fits through an opening with this clearance.
inline constexpr float kFitsM = 0.25F;
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

/// The saddle of each two pieces a < b that touch, at the cell of a.
using BorderSaddles = std::map<std::pair<std::uint32_t, std::uint32_t>, Saddle>;

/// Regions made of pieces that only ever join, with the widest saddle to each neighbour.
class RegionGraph {
public:
    /// One region a piece (labels 1 .. num_pieces). The rasters must outlive the graph. O(cells).
    RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                const Raster<float>& clearance_m, double resolution_m,
                const Executor& executor = {});
    /// The same, of which the saddles are known.
    RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                const BorderSaddles& saddles, const Raster<float>& clearance_m, double resolution_m,
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
        return saddles_[region];
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

    /// What lies on both sides of the saddle between two regions that touch. What a join has not
    /// come near to is not measured again.
    [[nodiscard]] Narrowing measure(std::uint32_t a, std::uint32_t b);
    /// Measures ahead what measure() will be asked for, on all threads: the saddles of a region up
    /// to a width; of all regions.
    void measure_around(std::uint32_t region, double max_width_m, const Executor& executor);
    void measure_all(double max_width_m, const Executor& executor);
    /// The same as measure() at another saddle between them, whose cell a lies in region a.
    [[nodiscard]] Narrowing measure_at(const Saddle& saddle, std::uint32_t a, std::uint32_t b,
                                       NarrowingGauge& gauge) const;

private:
    struct Extent {
        double area_m2 = 0.0;
        double peak_m = 0.0;
        /// Of the raster's cells, whole numbers: their sums are exact in any order.
        double num_cells = 0.0;
        double sum_x = 0.0;
        double sum_y = 0.0;
        /// Openings beyond the raster.
        std::size_t num_openings = 0;
    };

    /// What has been measured at a saddle, as far as it still holds.
    struct Measured {
        std::optional<Opening> opening;
        /// On the saddle's sides a and b.
        std::array<std::optional<WalkedSide>, 2> sides;
    };

    void forget_if_met(std::uint32_t own, std::uint32_t other, std::uint32_t joined);
    void complete(const Saddle& saddle, Measured& measured, NarrowingGauge& gauge) const;
    /// A saddle of which something is still to be measured.
    struct Unmeasured {
        const Saddle* saddle = nullptr;
        Measured* measured = nullptr;
    };
    void collect_unmeasured(std::uint32_t region, double max_width_m, bool is_each_once,
                            std::vector<Unmeasured>& found);
    void measure(std::span<const Unmeasured> saddles, const Executor& executor);
    void describe(std::uint32_t a, std::uint32_t b, Narrowing& narrowing) const;

    std::function<void(std::uint32_t a, std::uint32_t b)> watcher_;
    const Raster<std::uint32_t>& pieces_;
    const Raster<float>& clearance_;
    double resolution_m_;
    /// One for each chunk of work that is done at the same time.
    std::vector<NarrowingGauge> gauges_;
    std::vector<std::uint32_t> region_;
    std::vector<std::vector<std::uint32_t>> members_;
    std::vector<Extent> extent_;
    std::vector<std::uint32_t> version_;
    std::vector<std::map<std::uint32_t, Saddle>> saddles_;
    /// Of regions a < b, at the saddle of a.
    std::map<std::pair<std::uint32_t, std::uint32_t>, Measured> measured_;
};

}  // namespace quadcut
