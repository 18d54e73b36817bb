// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/narrowing.hpp"
#include "quadcut/rooms/wall_lines.hpp"

namespace quadcut {

/// The saddle of each two pieces a < b that touch, at the cell of a.
using BorderSaddles = std::map<std::pair<std::uint32_t, std::uint32_t>, Saddle>;

/// The widest saddle of each two labels that touch where there is clearance. O(cells).
[[nodiscard]] BorderSaddles border_saddles(const Raster<std::uint32_t>& pieces,
                                           const Raster<float>& clearance_m, const WallLines& lines,
                                           const Executor& executor);

/// The borders between regions that only ever join, as one clearance shows them: the widest saddle
/// of each, and what was measured there as far as it still holds.
class Borders {
public:
    /// The clearance must outlive the borders.
    Borders(const BorderSaddles& saddles, std::uint32_t num_pieces,
            const Raster<float>& clearance_m, double resolution_m);

    [[nodiscard]] const std::map<std::uint32_t, Saddle>& of(std::uint32_t region) const {
        return saddles_[region];
    }
    /// Region b becomes a part of a; the saddles of both to a third region become the wider one.
    /// `regions` is as before.
    void join(std::uint32_t a, std::uint32_t b, const RegionsView& regions);

    /// The narrowing between two regions; nothing where they do not touch. What a join has not come
    /// near to is not measured again. Areas, peaks and openings of the regions are left out.
    [[nodiscard]] std::optional<Narrowing> measure(std::uint32_t a, std::uint32_t b,
                                                   const RegionsView& regions);
    /// Measures ahead what measure() will be asked for, on all threads: the saddles of a region up
    /// to a width; of all regions.
    void measure_around(std::uint32_t region, double max_width_m, const RegionsView& regions,
                        const Executor& executor);
    void measure_all(double max_width_m, const RegionsView& regions, const Executor& executor);

private:
    struct Measured {
        std::optional<Opening> opening;
        /// On the saddle's sides a and b.
        std::array<std::optional<WalkedSide>, 2> sides;
    };
    /// A saddle of which something is still to be measured.
    struct Unmeasured {
        const Saddle* saddle = nullptr;
        Measured* measured = nullptr;
    };

    void forget_if_met(std::uint32_t own, std::uint32_t other, std::uint32_t joined,
                       const RegionsView& regions);
    void complete(const Saddle& saddle, const RegionsView& regions, Measured& measured,
                  NarrowingGauge& gauge) const;
    void collect_unmeasured(std::uint32_t region, double max_width_m, bool is_each_once,
                            std::vector<Unmeasured>& found);
    void measure(std::span<const Unmeasured> saddles, const RegionsView& regions,
                 const Executor& executor);

    const Raster<float>& clearance_;
    double resolution_m_;
    /// One for each chunk of work that is done at the same time.
    std::vector<NarrowingGauge> gauges_;
    std::vector<std::map<std::uint32_t, Saddle>> saddles_;
    /// Of regions a < b, at the saddle of a.
    std::map<std::pair<std::uint32_t, std::uint32_t>, Measured> measured_;
};

}  // namespace quadcut
