// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/graph/graph.hpp"
#include "quadcut/segment/segmentation.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// Pieces 0 .. count - 1 of a region, by node of its graph. Each is connected in the graph.
struct Pieces {
    std::vector<std::uint32_t> piece_of_node;
    std::uint32_t count = 0;
    /// One entry for each solve.
    std::vector<EigenReport> eigen;
};

struct CutOptions {
    LaplacianKind laplacian = LaplacianKind::degree;
    /// Pieces are found as many as this; 0: as many as the silhouette likes best.
    std::size_t num_pieces = 0;
    std::size_t max_pieces = 30;
    double min_silhouette = 0.25;
    RowScaling row_scaling = RowScaling::none;
    std::uint64_t seed = 1;
};

/// The paper's cut of a region (eqs. 4 to 9): the smallest eigenvectors of its Laplacian, the
/// spectra of its components merged, their rows clustered by k-means, into a given number of
/// clusters or the one with the best silhouette. A cluster that falls apart becomes several pieces.
/// Throws NumericalError if the eigensolver fails its own checks.
[[nodiscard]] Pieces cut(const Graph& region, const CutOptions& options, StageClock& clock,
                         const Executor& executor = {});

struct OverCutOptions {
    /// A region is cut while it has more than one eigenvalue below this, 1/m^2.
    double max_eigenvalue_per_m2 = 0.8;
    /// Eigenpairs of one solve; a region with more of them below the limit is cut recursively, so
    /// that no solve grows with the size of the map.
    std::size_t max_pairs = 24;
    /// By degree, or unweighted, eigenvalues and their limit have no unit.
    LaplacianKind laplacian = LaplacianKind::area;
    std::uint64_t seed = 1;
};

/// Cuts a region finer than rooms: by default an area-normalised Laplacian, all eigenvectors below
/// the limit, column-pivoted QR and a few k-means steps. By Weyl's law an eigenvalue limit of 0.8 /
/// m^2 gives pieces of about 16 m^2; every doorway is among the cuts, and so are many that are
/// none. A connected part of more than 65,536 nodes is first cut into parts of about 16,384 by
/// cut_multilevel(), so that no solve grows with the size of the map. Throws NumericalError if the
/// eigensolver fails its own checks.
[[nodiscard]] Pieces over_cut(const Graph& region, const OverCutOptions& options, StageClock& clock,
                              const Executor& executor = {});

}  // namespace quadcut
