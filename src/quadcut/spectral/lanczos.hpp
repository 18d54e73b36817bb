// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {

/// Eigenvalues, and vectors of the length of L, orthonormal, one after the other.
struct LanczosPairs {
    std::vector<double> values;
    std::vector<double> vectors;
};

/// The `count` smallest eigenpairs of L but those whose vectors are `known` (orthonormal, one after
/// the other), eigenvalues ascending but for what is found late: block Lanczos with the inverse of
/// L - sigma I, full reorthogonalisation, thick restarts (Wu, Simon 2000) and locking of what has
/// converged. `factor` holds a factorisation at a sigma below zero. Residuals |L v - lambda v| are
/// at most `max_residual`, by estimate. Copies of a multiple eigenvalue may be passed over, and
/// pairs are missing where the search makes no progress. Cost: two to four solves a pair, and as
/// many times count + known products of vectors.
[[nodiscard]] LanczosPairs find_smallest_pairs(const ShiftedFactor& factor,
                                               std::span<const double> known, std::size_t count,
                                               double max_residual, Random& random,
                                               const Executor& executor);

}  // namespace quadcut
