// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/paper/cut.hpp"
#include "quadcut/paper/options.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// The submaps of a region.
struct Submaps {
    /// The nodes that are in one, ascending.
    std::vector<std::uint32_t> nodes;
    /// Their submaps, by place in `nodes`.
    Pieces pieces;
};

/// The paper's method on a region's graph: small connected components are eliminated, the rest is
/// cut, the submaps divided and fused. A number that is given is cut to.
/// Throws NumericalError if the eigensolver fails its own checks.
[[nodiscard]] Submaps find_submaps(const Graph& graph, const PaperOptions& options,
                                   std::uint64_t seed, StageClock& clock, const Executor& executor);

}  // namespace quadcut
