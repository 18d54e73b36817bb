// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/eigensolver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include <Eigen/Dense>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/spectral/lanczos.hpp"
#include "quadcut/spectral/shifted_factor.hpp"

namespace quadcut {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How far below zero the shift is, as a share of the norm. The nearer, the better for eigenvalues
/// that hardly differ from zero; the farther, the less of their rounding errors in the others.
constexpr double kNearShift = 1e-8;
constexpr double kFarShift = 1e-6;
/// Shares of the norm: eigenvalues this close count as equal; the slack of a limit or a count.
constexpr double kEqual = 1e-10;
constexpr double kSlack = 1e-9;
/// Where an eigenvalue count is tried: shares of the norm below the place asked for.
constexpr double kNudges[] = {0.0, 1e-9, 3e-9, 1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 3e-6};
/// Growth of a factorisation up to which it is good for counting.
constexpr double kCountGrowth = 1e7;
constexpr int kMaxRounds = 20;
constexpr double kOrthonormal = 1e-8;
constexpr std::size_t kProductsAtOnce = 4;

Eigen::Map<MatrixXd> vectors_of(Eigenpairs& pairs) {
    return {pairs.vectors.data(), static_cast<Index>(pairs.num_nodes),
            static_cast<Index>(pairs.size())};
}

/// Rayleigh quotients, signs and residuals; checks the residuals and the orthonormality.
void finish(const Laplacian& laplacian, const EigenOptions& options, const Executor& executor,
            Eigenpairs& pairs) {
    Eigen::Map<MatrixXd> vectors = vectors_of(pairs);
    pairs.residuals.resize(pairs.size());
    const auto gram = [&] {
        MatrixXd products = MatrixXd::Zero(vectors.cols(), vectors.cols());
        products.selfadjointView<Eigen::Lower>().rankUpdate(vectors.transpose());
        return MatrixXd(products.selfadjointView<Eigen::Lower>());
    };
    if (const MatrixXd products = gram(); !products.isIdentity(kOrthonormal)) {
        // Where weights span many decades: pairs that hardly differ from zero.
        products.llt().matrixU().solveInPlace<Eigen::OnTheRight>(vectors);
        if (!gram().isIdentity(kOrthonormal)) {
            throw NumericalError("eigensolver: the vectors are not orthonormal");
        }
    }
    // A device is handed all vectors at once; without one, new memory costs more than the products.
    const std::size_t num_at_once =
        executor.accelerator != nullptr ? pairs.size() : std::min(kProductsAtOnce, pairs.size());
    const std::size_t size = pairs.num_nodes;
    MatrixXd products(vectors.rows(), static_cast<Index>(num_at_once));
    for (std::size_t first = 0; first < pairs.size(); first += num_at_once) {
        const std::size_t count = std::min(num_at_once, pairs.size() - first);
        laplacian.apply_block(std::span(pairs.vectors).subspan(first * size, count * size),
                              {products.data(), count * size}, executor);
        parallel_for(executor, count, 1, [&](std::size_t i, std::size_t) {
            const std::size_t j = first + i;
            const auto product = products.col(static_cast<Index>(i));
            auto vector = vectors.col(static_cast<Index>(j));
            pairs.values[j] = std::max(0.0, vector.dot(product));
            pairs.residuals[j] = (product - pairs.values[j] * vector).norm();
            Index largest = 0;
            vector.cwiseAbs().maxCoeff(&largest);
            if (vector[largest] < 0.0) vector = -vector;
        });
    }
    const double residual = *std::max_element(pairs.residuals.begin(), pairs.residuals.end());
    if (residual > options.tolerance * laplacian.norm_bound()) {
        throw NumericalError("eigensolver: the residual of an eigenpair is too large");
    }
}

/// A place in the spectrum and the number of eigenvalues below it.
struct Mark {
    double at = 0.0;
    std::size_t num_below = 0;
};

/// Counts the eigenvalues below `at`, or a little below it where rounding forbids.
Mark count_below(ShiftedFactor& factor, double at, double norm) {
    for (const double nudge : kNudges) {
        const double place = at - nudge * norm;
        const auto [num_below, growth] = factor.factorize(place);
        // However low the place, the eigenvalue zero is below it.
        if (growth <= kCountGrowth) return {place, std::max<std::size_t>(1, num_below)};
    }
    throw NumericalError("eigensolver: no stable factorisation of L - sigma I near sigma = " +
                         std::to_string(at));
}

/// A mark just below the last cluster of equal eigenvalues: inside it there is none. At zero if all
/// are one cluster.
Mark mark_below_last(ShiftedFactor& factor, std::vector<double> values, double norm) {
    std::sort(values.begin(), values.end());
    std::size_t first = values.size() - 1;
    while (first > 0 && values[first] - values[first - 1] <= 4.0 * kSlack * norm) --first;
    if (first == 0) return {};
    return count_below(factor, values[first] - 2.0 * kSlack * norm, norm);
}

Eigenpairs null_pair(const Laplacian& laplacian) {
    Eigenpairs pairs;
    pairs.num_nodes = laplacian.size();
    pairs.values = {0.0};
    pairs.vectors.assign(laplacian.null_vector().begin(), laplacian.null_vector().end());
    vectors_of(pairs).colwise().normalize();
    return pairs;
}

/// Looks until as many pairs are found as the inertia says there are.
Eigenpairs solve_at(double shift, const Laplacian& laplacian, double limit, std::size_t max_count,
                    const EigenOptions& options, const Executor& executor) {
    const double norm = laplacian.norm_bound();
    const double max_residual = 0.01 * options.tolerance * norm;
    ShiftedFactor factor(laplacian);
    Mark end{limit, laplacian.size()};
    if (limit < norm) end = count_below(factor, limit, norm);
    const std::size_t num_wanted = std::min(max_count, end.num_below);
    Eigenpairs pairs = null_pair(laplacian);
    Random random(options.seed);
    std::size_t num_missing = num_wanted - 1;
    for (int round = 0; num_missing > 0; ++round) {
        factor.factorize(-shift * norm);
        const LanczosPairs more =
            find_smallest_pairs(factor, pairs.vectors, num_missing, max_residual, random, executor);
        if (more.values.size() < num_missing || round == kMaxRounds) {
            throw NumericalError("eigensolver: " + std::to_string(num_missing) + " of " +
                                 std::to_string(num_wanted) + " eigenpairs not found");
        }
        pairs.values.insert(pairs.values.end(), more.values.begin(), more.values.end());
        pairs.vectors.insert(pairs.vectors.end(), more.vectors.begin(), more.vectors.end());
        // Sylvester: what lies below a mark has been found, or copies were passed over.
        const Mark mark =
            num_wanted == end.num_below ? end : mark_below_last(factor, pairs.values, norm);
        const auto num_found = static_cast<std::size_t>(
            std::count_if(pairs.values.begin(), pairs.values.end(),
                          [&](double value) { return value < mark.at + kSlack * norm; }));
        num_missing = mark.num_below - std::min(mark.num_below, num_found);
    }
    finish(laplacian, options, executor, pairs);
    return pairs;
}

/// Eigenpairs of a connected graph's Laplacian: the `max_count` smallest of those below `limit`.
/// There may be more, and their order is any. Eigenvalues within 3e-6 of the norm may stand for
/// each other where no factorisation between them is stable.
Eigenpairs solve_connected(const Laplacian& laplacian, double limit, std::size_t max_count,
                           const EigenOptions& options, const Executor& executor) {
    try {
        return solve_at(kNearShift, laplacian, limit, max_count, options, executor);
    } catch (const NumericalError&) {
        return solve_at(kFarShift, laplacian, limit, max_count, options, executor);
    }
}

std::vector<std::vector<std::uint32_t>> nodes_by_component(const Graph& graph) {
    const std::vector<std::uint32_t> component = connected_components(graph);
    std::vector<std::vector<std::uint32_t>> nodes;
    for (std::uint32_t i = 0; i < component.size(); ++i) {
        if (component[i] >= nodes.size()) nodes.resize(component[i] + std::size_t{1});
        nodes[component[i]].push_back(i);
    }
    return nodes;
}

/// A candidate of the merged spectrum: the eigenvalue in steps of what counts as equal, the
/// component, the eigenvalue, and the place among the component's pairs.
using Candidate = std::tuple<double, std::uint32_t, double, std::size_t>;

Eigenpairs solve_and_merge(const Graph& graph, LaplacianKind kind, double limit,
                           std::size_t max_count, const EigenOptions& options,
                           const Executor& executor) {
    Eigenpairs pairs;
    pairs.num_nodes = graph.num_nodes();
    if (max_count == 0 || !(limit > 0.0)) return pairs;
    const Laplacian whole(graph, kind);
    const double norm = whole.norm_bound();
    const auto null_vector = whole.null_vector();
    const auto nodes = nodes_by_component(graph);
    const auto solve = [&](const Laplacian& laplacian) {
        return solve_connected(laplacian, limit, max_count, options, executor);
    };
    std::vector<Eigenpairs> solved(nodes.size());
    std::vector<Candidate> candidates;
    for (std::uint32_t c = 0; c < nodes.size(); ++c) {
        // Each component has an eigenvalue zero, and no smaller one.
        const bool is_full = candidates.size() == max_count;
        if (is_full && candidates.back() < Candidate{0.0, c, 0.0, 0}) continue;
        solved[c] = nodes.size() == 1 ? solve(whole)
                                      : solve(Laplacian(induced_subgraph(graph, nodes[c]), kind));
        for (std::size_t j = 0; j < solved[c].size(); ++j) {
            const double value = solved[c].values[j];
            if (value > limit + kSlack * norm) continue;
            candidates.emplace_back(std::round(value / (kEqual * norm)), c, value, j);
        }
        std::sort(candidates.begin(), candidates.end());
        if (candidates.size() < max_count) continue;
        // What is found limits what the other components are asked for.
        candidates.resize(max_count);
        limit = std::min(limit, std::get<2>(candidates.back()) + kSlack * norm);
    }

    const bool is_as_solved =
        nodes.size() == 1 && candidates.size() == solved[0].size() &&
        std::is_sorted(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
            return std::get<3>(a) < std::get<3>(b);
        });
    if (is_as_solved) {
        pairs = std::move(solved[0]);
        pairs.null_vector.assign(null_vector.begin(), null_vector.end());
        pairs.components.assign(pairs.size(), 0);
        return pairs;
    }
    pairs.null_vector.assign(null_vector.begin(), null_vector.end());
    pairs.vectors.assign(candidates.size() * pairs.num_nodes, 0.0);
    for (const auto& [rank, component, value, j] : candidates) {
        const auto source = solved[component].vector(j);
        const auto& members = nodes[component];
        double* vector = pairs.vectors.data() + pairs.size() * pairs.num_nodes;
        for (std::size_t i = 0; i < members.size(); ++i) vector[members[i]] = source[i];
        pairs.values.push_back(value);
        pairs.components.push_back(component);
        pairs.residuals.push_back(solved[component].residuals[j]);
    }
    return pairs;
}

}  // namespace

Eigenpairs smallest_eigenpairs(const Graph& graph, LaplacianKind kind, std::size_t count,
                               const EigenOptions& options, const Executor& executor) {
    return solve_and_merge(graph, kind, std::numeric_limits<double>::infinity(), count, options,
                           executor);
}

Eigenpairs eigenpairs_below(const Graph& graph, LaplacianKind kind, double limit,
                            std::size_t max_count, const EigenOptions& options,
                            const Executor& executor) {
    if (std::isnan(limit)) throw std::logic_error("eigenpairs_below: the limit is not a number");
    return solve_and_merge(graph, kind, limit, max_count, options, executor);
}

}  // namespace quadcut
