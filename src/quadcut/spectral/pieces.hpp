// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadcut {

/// The eigenpairs that one cut of a region used.
struct EigenReport {
    std::size_t num_nodes = 0;
    std::vector<double> eigenvalues;
    std::vector<double> residuals;
};

/// What a cut was made of: leaves of the quadtree and the graph's edges; or basins, and the pairs
/// of them that touch.
struct CutReport {
    std::size_t num_leaves = 0;
    std::size_t num_edges = 0;
    std::vector<EigenReport> eigen;
};

/// Pieces 0 .. count - 1 of a region, by node of its graph. Each is connected in the graph.
struct Pieces {
    std::vector<std::uint32_t> piece_of_node;
    std::uint32_t count = 0;
    /// One entry for each solve.
    std::vector<EigenReport> eigen;
};

}  // namespace quadcut
