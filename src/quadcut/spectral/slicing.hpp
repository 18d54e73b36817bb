// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {

/// Which eigenpairs are wanted: those with eigenvalues below `limit`, the `max_count` smallest at
/// most.
struct SpectrumRequest {
    double limit = 0.0;
    std::size_t max_count = 0;
};

/// A place in the spectrum and the number of eigenvalues below it.
struct SpectrumMark {
    double at = 0.0;
    std::size_t num_below = 0;
};

/// The part of the spectrum between two marks, and how many of its eigenpairs are wanted: all, or
/// as many as are missing of (nearly) one multiple eigenvalue.
struct SpectrumSlice {
    SpectrumMark low;
    SpectrumMark high;
    std::size_t num_wanted = 0;
};

/// Divides the wanted part of a spectrum into slices, ascending, of some tens of pairs each. The
/// inertia of L - sigma I counts the eigenvalues below sigma, so the numbers are certain. There may
/// be a few pairs more than wanted. Eigenvalues within 1e-6 of the norm may stand for each other
/// where no factorisation between them is stable; otherwise within 1e-9.
/// Cost: some ten factorisations, and one or two a slice. Throws NumericalError.
[[nodiscard]] std::vector<SpectrumSlice> plan_slices(const Laplacian& laplacian,
                                                     ShiftedFactor& factor,
                                                     const SpectrumRequest& request,
                                                     Random& random);

/// Narrows the slice until there are eigenvalues on both sides of its middle, and leaves `factor`
/// near there: `random` says where, since a symmetric map may well have an eigenvalue right in the
/// middle. @pre a pair of the slice is wanted.
[[nodiscard]] SpectrumSlice place_shift(const SpectrumSlice& slice, ShiftedFactor& factor,
                                        Random& random);

}  // namespace quadcut
