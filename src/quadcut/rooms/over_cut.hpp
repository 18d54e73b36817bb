// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

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
