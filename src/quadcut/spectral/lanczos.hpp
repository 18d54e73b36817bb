// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {

/// An interval [low, high) of the spectrum, and how many eigenpairs of it are wanted.
struct SpectrumSlice {
    double low = 0.0;
    double high = 0.0;
    std::size_t num_wanted = 0;
};

struct LanczosOptions {
    /// Largest residual |L v - lambda v|.
    double max_residual = 0.0;
    std::uint64_t seed = 1;
};

/// Eigenpairs of one slice, eigenvalues ascending, vectors orthonormal and of the length of L, one
/// after the other, in the order of the factor.
struct SlicePairs {
    std::vector<double> values;
    std::vector<double> vectors;
};

/// Block Lanczos with the inverse of L - shift I, full reorthogonalisation, and locking of what has
/// converged when it starts anew (Grimes, Lewis, Simon 1994; Parlett 1998). `factor` holds the
/// factorisation at `shift`, inside the slice. `null_vector`, of length 1, is kept out of the
/// search: it is known. Returns fewer pairs than wanted if no more are found.
[[nodiscard]] SlicePairs find_slice_pairs(const ShiftedFactor& factor, double shift,
                                          const SpectrumSlice& slice,
                                          std::span<const double> null_vector,
                                          const LanczosOptions& options);

}  // namespace quadcut
