// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/run_options.hpp"
#include "quadcut/segment/options.hpp"
#include "reproduce/figure.hpp"
#include "reproduce/followed.hpp"
#include "reproduce/world.hpp"

namespace quadcut::reproduce {

/// How experiments are to run.
struct Setup {
    RunOptions run;
    std::uint64_t seed = 1;
    Size size = Size::full;

    [[nodiscard]] Executor executor() const { return run.executor(); }
    [[nodiscard]] SegmentOptions rooms() const {
        SegmentOptions options;
        options.seed = seed;
        return options;
    }
    /// num_submaps 0: as the preset finds it.
    [[nodiscard]] SegmentOptions paper(std::size_t num_submaps) const {
        SegmentOptions options = rooms();
        options.preset = Preset::paper;
        options.paper.num_submaps = num_submaps;
        return options;
    }
    /// The number of submaps as the paper finds it, whatever the preset does.
    [[nodiscard]] SegmentOptions paper_by_silhouette() const {
        SegmentOptions options = paper(0);
        options.paper.first_cut = FirstCut::silhouette;
        return options;
    }
};

struct Worlds {
    World workplace;
    World mit_csail;
    World intel;
    World laboratory;
};

/// The same scans, followed in both presets.
struct FollowedTwice {
    Followed paper;
    Followed rooms;
};

/// All worlds, followed.
struct FollowedWorlds {
    FollowedTwice workplace;
    FollowedTwice mit_csail;
    FollowedTwice intel;
    FollowedTwice laboratory;
};

// Each the counterpart of the figures in its name. Times are wall times.

/// Construction, nodes and look-ups: quadtree against occupancy grid.
[[nodiscard]] Figure figure_4(const Worlds& worlds, const Setup& setup);
/// Dense and filtered matrix.
[[nodiscard]] Figure figure_6(const Worlds& worlds, const Setup& setup);
/// Time of the edges against the number of threads.
[[nodiscard]] Figure figure_7(const Worlds& worlds, const Setup& setup);
/// The pipeline on the workplace.
[[nodiscard]] Figure figure_11(const Worlds& worlds, const Setup& setup);
/// The same and the other worlds, incrementally.
[[nodiscard]] Figure figure_12(const Worlds& worlds, const FollowedWorlds& followed);
/// ps over time.
[[nodiscard]] Figure figure_13(const Worlds& worlds);
/// Size of the matrix and time over scans.
[[nodiscard]] Figure figure_14(const Worlds& worlds, const FollowedWorlds& followed);
/// MIT-CSAIL with k = 10.
[[nodiscard]] Figure figures_15_to_17(const Worlds& worlds, const Setup& setup);

/// The paper's 17,300 and 43 ms, and ours, beside the figure.
struct IntelResult {
    Figure figure;
    std::vector<Headline> headlines;
};
/// The Intel lab, whole and locally.
[[nodiscard]] IntelResult figure_18(const Worlds& worlds, const FollowedTwice& intel,
                                    const Setup& setup);
/// A robot in a cluttered laboratory.
[[nodiscard]] Figure figures_20_to_22(const Worlds& worlds, const FollowedTwice& laboratory,
                                      const Setup& setup);

}  // namespace quadcut::reproduce
