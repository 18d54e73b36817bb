// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// Which eigenpairs are wanted: those with eigenvalues below `limit`, the `max_count` smallest at
/// most.
struct SpectrumRequest {
    double limit = 0.0;
    std::size_t max_count = 0;
};

/// Eigenpairs of a connected graph's Laplacian, eigenvalues ascending; the vectors, each of length
/// size() of the Laplacian, stand one after the other.
struct ConnectedPairs {
    std::vector<double> values;
    std::vector<double> vectors;
    std::vector<double> residuals;
};

/// Solves by slicing the spectrum: the inertia of L - sigma I tells how many eigenvalues lie below
/// sigma, so the wanted part is divided into slices of known, small numbers of pairs, and each is
/// found by a short Lanczos run around a shift of its own. Slices are independent: they run in
/// parallel, the cost grows in proportion to the pairs, and the count is certain.
/// @pre the graph is connected. Throws NumericalError when the answer does not pass its checks.
[[nodiscard]] ConnectedPairs solve_connected(const Laplacian& laplacian,
                                             const SpectrumRequest& request,
                                             const EigenOptions& options, const Executor& executor);

}  // namespace quadcut
