// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

struct EigenOptions {
    /// Largest residual |L v - lambda v| of an eigenpair, as a share of L's norm_bound().
    double tolerance = 1e-9;
    /// Seed of the start vectors.
    std::uint64_t seed = 1;
};

/// Eigenpairs of a graph's Laplacian, eigenvalues ascending; equal ones (to 1e-10 of the norm) in
/// order of component. Vectors are orthonormal; each belongs to one connected component and is zero
/// elsewhere; its entry of largest magnitude (the first such) is positive.
struct Eigenpairs {
    /// Length of a vector: the nodes of the whole graph.
    std::size_t num_nodes = 0;
    std::vector<double> values;
    /// Pair j's vector is vectors[j * num_nodes .. (j + 1) * num_nodes).
    std::vector<double> vectors;
    /// Pair j's connected component, numbered as connected_components() does.
    std::vector<std::uint32_t> components;
    /// The Laplacian's null_vector(): by node.
    std::vector<double> null_vector;
    /// |L v - lambda v| of each pair, as measured on what is returned.
    std::vector<double> residuals;

    [[nodiscard]] std::size_t size() const { return values.size(); }
    [[nodiscard]] std::span<const double> vector(std::size_t j) const {
        return std::span(vectors).subspan(j * num_nodes, num_nodes);
    }
};

/// The `count` smallest eigenpairs (all of them if the graph has fewer nodes) of the graph's
/// Laplacian. Components are split first, each is solved, and the spectra are merged.
///
/// What is returned has been checked: residuals, orthonormality, and, by the inertia of a
/// factorisation of L - sigma I (Sylvester), that no smaller eigenvalue was passed over. Throws
/// NumericalError when a check fails, std::logic_error where Laplacian() does.
/// Cost: two sparse factorisations for each component, two to four solves a pair, and as many times
/// `count` products of vectors; memory about 2.3 count + 38 vectors (258 + 2 count at most).
[[nodiscard]] Eigenpairs smallest_eigenpairs(const Graph& graph, LaplacianKind kind,
                                             std::size_t count, const EigenOptions& options = {},
                                             const Executor& executor = {});

/// All eigenpairs with an eigenvalue below `limit` (in the unit of `kind`), but the `max_count`
/// smallest at most. An eigenvalue within 1e-9 of the norm from the limit may fall on either side
/// (3e-6 where no factorisation nearer is stable). Checked, and throws, as smallest_eigenpairs();
/// one factorisation more, at the limit, says how many there are.
[[nodiscard]] Eigenpairs eigenpairs_below(const Graph& graph, LaplacianKind kind, double limit,
                                          std::size_t max_count, const EigenOptions& options = {},
                                          const Executor& executor = {});

}  // namespace quadcut
