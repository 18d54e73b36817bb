// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// An orthonormal basis of a Laplacian's null space: vector j is
/// vectors[j * num_nodes .. (j + 1) * num_nodes). Some rotation of the components' indicators.
struct NullSpace {
    std::size_t num_nodes = 0;
    std::size_t dimension = 0;
    std::vector<double> vectors;
};

/// The null space of the Laplacian of any graph, found without looking at the graph's components:
/// its dimension is the number of eigenvalues below 1e-9 of the norm (inertia of a factorisation),
/// its basis comes by Lanczos steps just below zero. Throws NumericalError when these do not
/// converge. Cost: two factorisations and a few solves per dimension.
[[nodiscard]] NullSpace find_null_space(const Laplacian& laplacian, std::uint64_t seed = 1);

/// The connected component of each node, numbered from 0 by first node, by the spectral way: nodes
/// whose rows of the null-space basis, divided by the null vector, are equal. The result is that of
/// connected_components(), which costs a thousandth; this one exists to check both. Components that
/// hang together by a coupling below 1e-9 of the norm count as separate.
[[nodiscard]] std::vector<std::uint32_t> components_from_null_space(
    const Graph& graph, LaplacianKind kind = LaplacianKind::degree, std::uint64_t seed = 1);

}  // namespace quadcut
