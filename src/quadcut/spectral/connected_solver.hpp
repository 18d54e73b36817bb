// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "quadcut/spectral/slicing.hpp"

namespace quadcut {

/// Eigenpairs of a connected graph's Laplacian, eigenvalues ascending; the vectors, each of length
/// size() of the Laplacian, stand one after the other.
struct ConnectedPairs {
    std::vector<double> values;
    std::vector<double> vectors;
    std::vector<double> residuals;
};

/// Solves by slicing the spectrum: each slice of a small, known number of pairs is found by a short
/// Lanczos run around a shift of its own. Slices are independent, so they run in parallel, and the
/// cost grows in proportion to the pairs.
/// @pre the graph is connected. Throws NumericalError when the answer does not pass its checks.
[[nodiscard]] ConnectedPairs solve_connected(const Laplacian& laplacian,
                                             const SpectrumRequest& request,
                                             const EigenOptions& options, const Executor& executor);

}  // namespace quadcut
