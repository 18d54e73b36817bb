// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/spectral/shifted_factor.hpp"
#include "quadcut/spectral/slicing.hpp"

namespace quadcut {

/// Eigenpairs of one slice, eigenvalues ascending, vectors orthonormal and of the length of L, one
/// after the other, in the order of the factor.
struct SlicePairs {
    std::vector<double> values;
    std::vector<double> vectors;
};

/// Block Lanczos with the inverse of L - sigma I, full reorthogonalisation, and locking of what has
/// converged when it starts anew (Grimes, Lewis, Simon 1994; Parlett 1998). `factor` holds a
/// factorisation at a shift inside the slice. `null_vector`, of length 1, is kept out of the
/// search: it is known. Pairs have residuals |L v - lambda v| of at most `max_residual`, by
/// estimate. Returns fewer than wanted if no more are found.
[[nodiscard]] SlicePairs find_slice_pairs(const ShiftedFactor& factor, const SpectrumSlice& slice,
                                          std::span<const double> null_vector, double max_residual,
                                          Random& random);

}  // namespace quadcut
