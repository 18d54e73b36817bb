// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/null_space.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {
namespace {

constexpr double kZero = 1e-9;
constexpr double kEqualRows = 1e-6;
constexpr int kNumPasses = 3;

double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Takes away what lies along the vectors before, twice, and scales to length 1. Whether anything
/// is left.
bool orthonormalize(std::span<double> vector, std::span<const double> before) {
    const std::size_t n = vector.size();
    double length = std::sqrt(dot(vector, vector));
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t j = 0; j < before.size() / n; ++j) {
            const auto other = before.subspan(j * n, n);
            const double along = dot(vector, other);
            for (std::size_t i = 0; i < n; ++i) vector[i] -= along * other[i];
        }
    }
    const double left = std::sqrt(dot(vector, vector));
    if (!(left > 1e-8 * length)) return false;
    for (double& value : vector) value /= left;
    return true;
}

/// One inverse iteration: (L - sigma I)^-1 of a vector in the order of L.
std::vector<double> solve(const ShiftedFactor& factor, std::span<const double> vector) {
    const auto order = factor.order();
    std::vector<double> permuted(vector.size());
    for (std::size_t i = 0; i < order.size(); ++i) permuted[i] = vector[order[i]];
    factor.solve(permuted, 1);
    std::vector<double> out(vector.size());
    for (std::size_t i = 0; i < order.size(); ++i) out[order[i]] = permuted[i];
    return out;
}

}  // namespace

NullSpace find_null_space(const Laplacian& laplacian, std::uint64_t seed) {
    NullSpace space;
    space.num_nodes = laplacian.size();
    if (space.num_nodes == 0) return space;
    const double norm = laplacian.norm_bound();
    ShiftedFactor factor(laplacian);
    space.dimension = factor.factorize(kZero * norm).num_below;
    // Just below zero the matrix is definite and its inverse is almost all null space.
    factor.factorize(-kZero * norm);
    Random random(seed);
    std::vector<double> image(space.num_nodes);
    for (std::size_t j = 0; j < space.dimension; ++j) {
        std::vector<double> vector(space.num_nodes);
        for (double& value : vector) value = random.normal();
        for (int pass = 0; pass < kNumPasses; ++pass) {
            if (!orthonormalize(vector, space.vectors)) break;
            vector = solve(factor, vector);
        }
        if (!orthonormalize(vector, space.vectors)) {
            throw NumericalError("null space: an inverse iteration found no new direction");
        }
        laplacian.apply(vector, image);
        if (!(std::sqrt(dot(image, image)) <= 10.0 * kZero * norm)) {
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
    const auto null_vector = laplacian.null_vector();
    // Departs from the paper: it sorts eigenvectors by their non-zero elements, yet a solver
    // returns any rotation of the null space. In every rotation, rows are equal on a component once
    // they are divided by the null vector. A node without edges has no entry there: it is alone.
    std::vector<std::uint32_t> component(graph.num_nodes());
    std::vector<std::size_t> first_nodes;
    const auto row_value = [&](std::size_t node, std::size_t j) {
        const double scale = null_vector[node] > 0.0 ? null_vector[node] : 1.0;
        return space.vectors[j * space.num_nodes + node] / scale;
    };
    for (std::size_t node = 0; node < graph.num_nodes(); ++node) {
        const auto same =
            std::find_if(first_nodes.begin(), first_nodes.end(), [&](std::size_t first) {
                if ((null_vector[node] > 0.0) != (null_vector[first] > 0.0)) return false;
                double difference = 0.0;
                double length = 0.0;
                for (std::size_t j = 0; j < space.dimension; ++j) {
                    const double a = row_value(node, j);
                    const double b = row_value(first, j);
                    difference += (a - b) * (a - b);
                    length += a * a + b * b;
                }
                return difference <= kEqualRows * kEqualRows * length;
            });
        if (same == first_nodes.end()) {
            component[node] = static_cast<std::uint32_t>(first_nodes.size());
            first_nodes.push_back(node);
        } else {
            component[node] = static_cast<std::uint32_t>(same - first_nodes.begin());
        }
    }
    return component;
}

}  // namespace quadcut
