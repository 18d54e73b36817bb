// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/null_space.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {
namespace {

/// Share of the norm: eigenvalues below it count as zero.
constexpr double kZero = 1e-9;
constexpr double kSmallResidual = 1e-13;
constexpr int kMaxPasses = 60;
/// Of two rows, squared, as a share of their squared lengths.
constexpr double kEqualRows = 1e-8;

double dot(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Takes away what lies along the vectors before, twice, and scales to length 1.
void orthonormalize(std::span<double> vector, std::span<const double> before) {
    const std::size_t size = vector.size();
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t j = 0; j < before.size() / size; ++j) {
            const auto other = before.subspan(j * size, size);
            const double along = dot(vector, other);
            for (std::size_t i = 0; i < size; ++i) vector[i] -= along * other[i];
        }
        const double length = std::sqrt(dot(vector, vector));
        if (!(length > 0.0)) throw NumericalError("null space: no direction is left");
        for (double& value : vector) value /= length;
    }
}

/// (L - sigma I)^-1 of a vector in the order of L.
std::vector<double> solve(const ShiftedFactor& factor, std::span<const double> vector) {
    const auto order = factor.order();
    std::vector<double> permuted(vector.size());
    for (std::size_t i = 0; i < order.size(); ++i) permuted[i] = vector[order[i]];
    factor.solve(permuted, 1);
    std::vector<double> result(vector.size());
    for (std::size_t i = 0; i < order.size(); ++i) result[order[i]] = permuted[i];
    return result;
}

double residual(const Laplacian& laplacian, std::span<const double> vector) {
    std::vector<double> image(vector.size());
    laplacian.apply(vector, image);
    return std::sqrt(dot(image, image)) / laplacian.norm_bound();
}

}  // namespace

NullSpace find_null_space(const Laplacian& laplacian, std::uint64_t seed) {
    NullSpace space;
    space.num_nodes = laplacian.size();
    if (space.num_nodes == 0) return space;
    ShiftedFactor factor(laplacian);
    space.dimension = factor.factorize(kZero * laplacian.norm_bound()).num_below;
    // Just below zero the matrix is definite, and its inverse is almost all null space.
    (void)factor.factorize(-0.1 * kZero * laplacian.norm_bound());
    Random random(seed);
    for (std::size_t j = 0; j < space.dimension; ++j) {
        std::vector<double> vector(space.num_nodes);
        for (double& value : vector) value = random.uniform(-1.0, 1.0);
        orthonormalize(vector, space.vectors);
        double left = 1.0;
        for (int pass = 0; pass < kMaxPasses && left > kSmallResidual; ++pass) {
            vector = solve(factor, vector);
            orthonormalize(vector, space.vectors);
            left = residual(laplacian, vector);
        }
        if (!(left <= kZero)) {
            throw NumericalError("null space: an inverse iteration did not converge");
        }
        space.vectors.insert(space.vectors.end(), vector.begin(), vector.end());
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
