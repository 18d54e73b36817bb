// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/null_space.hpp"

#include <algorithm>
#include <cstddef>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/spectral/lanczos.hpp"
#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {
namespace {

/// Share of the norm: eigenvalues below it count as zero.
constexpr double kZero = 1e-9;
/// Share of the norm. Next to a shift this near, a vector with more of a residual is not of
/// length 1.
constexpr double kSmallResidual = 1e-17;
/// Of two rows, squared, as a share of their squared lengths.
constexpr double kEqualRows = 1e-8;

}  // namespace

NullSpace find_null_space(const Laplacian& laplacian, std::uint64_t seed) {
    if (laplacian.size() == 0) return {};
    const double norm = laplacian.norm_bound();
    ShiftedFactor factor(laplacian);
    NullSpace space{laplacian.size(), factor.factorize(kZero * norm).num_below, {}};
    // Just below zero the matrix is definite, and its inverse is almost all null space.
    factor.factorize(-0.1 * kZero * norm);
    Random random(seed);
    for (std::size_t num_missing = space.dimension; num_missing > 0;) {
        const LanczosPairs pairs = find_smallest_pairs(factor, space.vectors, num_missing,
                                                       kSmallResidual * norm, random, {});
        const std::size_t before = num_missing;
        for (std::size_t j = 0; j < pairs.values.size(); ++j) {
            // Where a copy of zero was passed over, there is another eigenvalue in its place.
            if (pairs.values[j] > kZero * norm) continue;
            const auto begin = pairs.vectors.begin() + j * space.num_nodes;
            space.vectors.insert(space.vectors.end(), begin, begin + space.num_nodes);
            --num_missing;
        }
        if (num_missing == before) {
            throw NumericalError("null space: the search did not converge");
        }
    }
    return space;
}

std::vector<std::uint32_t> components_from_null_space(const Graph& graph, LaplacianKind kind,
                                                      std::uint64_t seed) {
    const Laplacian laplacian(graph, kind);
    const NullSpace space = find_null_space(laplacian, seed);
    // Departs from the paper: it sorts eigenvectors by their non-zero elements, yet a solver
    // returns any rotation of the null space. In every rotation, the rows of the nodes of one
    // component are equal once they are divided by the null vector, and those of two components are
    // orthogonal.
    const auto value = [&](std::size_t node, std::size_t j) {
        return space.vectors[j * space.num_nodes + node] / laplacian.null_vector()[node];
    };
    const auto are_equal = [&](std::size_t a, std::size_t b) {
        double difference = 0.0;
        double lengths = 0.0;
        for (std::size_t j = 0; j < space.dimension; ++j) {
            const double of_a = value(a, j);
            const double of_b = value(b, j);
            difference += (of_a - of_b) * (of_a - of_b);
            lengths += of_a * of_a + of_b * of_b;
        }
        return difference <= kEqualRows * lengths;
    };
    std::vector<std::uint32_t> component(graph.num_nodes());
    std::vector<std::size_t> first_nodes;
    for (std::size_t node = 0; node < graph.num_nodes(); ++node) {
        const auto same = std::find_if(first_nodes.begin(), first_nodes.end(),
                                       [&](std::size_t first) { return are_equal(node, first); });
        component[node] = static_cast<std::uint32_t>(same - first_nodes.begin());
        if (same == first_nodes.end()) first_nodes.push_back(node);
    }
    return component;
}

}  // namespace quadcut
