// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/connected_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

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

/// Up to here the dense solver is faster.
constexpr std::size_t kDenseSize = 64;
constexpr int kMaxAttempts = 3;
constexpr double kOrthonormal = 1e-8;
constexpr Index kCheckBlock = 32;

std::string scientific(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

/// Rayleigh quotients, signs, residuals and the order of eigenvalues.
ConnectedPairs finish(const Laplacian& laplacian, const MatrixXd& vectors,
                      std::span<const std::uint32_t> order, std::size_t num_kept,
                      const Executor& executor) {
    const std::size_t size = laplacian.size();
    const std::size_t num_pairs = static_cast<std::size_t>(vectors.cols());
    std::vector<double> all(size * num_pairs);
    std::vector<double> values(num_pairs);
    std::vector<double> residuals(num_pairs);
    parallel_for(executor, num_pairs, 4, [&](std::size_t first, std::size_t last) {
        VectorXd product(static_cast<Index>(size));
        for (std::size_t j = first; j < last; ++j) {
            Eigen::Map<VectorXd> vector(all.data() + j * size, static_cast<Index>(size));
            const auto column = vectors.col(static_cast<Index>(j));
            for (std::size_t i = 0; i < size; ++i) {
                vector[order[i]] = column[static_cast<Index>(i)];
            }
            laplacian.apply({vector.data(), size}, {product.data(), size});
            const double value = vector.dot(product);
            values[j] = std::max(0.0, value);
            residuals[j] = (product - values[j] * vector).norm();
            Index largest = 0;
            vector.cwiseAbs().maxCoeff(&largest);
            if (vector[largest] < 0.0) vector = -vector;
        }
    });
    std::vector<std::size_t> by_value(num_pairs);
    std::iota(by_value.begin(), by_value.end(), std::size_t{0});
    std::stable_sort(by_value.begin(), by_value.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    by_value.resize(std::min(num_kept, num_pairs));
    ConnectedPairs result;
    result.vectors.reserve(by_value.size() * size);
    for (const std::size_t j : by_value) {
        result.values.push_back(values[j]);
        result.residuals.push_back(residuals[j]);
        const auto vector = std::span(all).subspan(j * size, size);
        result.vectors.insert(result.vectors.end(), vector.begin(), vector.end());
    }
    return result;
}

/// Largest error of the scalar products of the vectors, as far as it may exceed kOrthonormal.
double orthonormality_error(const ConnectedPairs& pairs, std::size_t size) {
    const Index num_pairs = static_cast<Index>(pairs.values.size());
    const Eigen::Map<const MatrixXd> vectors(pairs.vectors.data(), static_cast<Index>(size),
                                             num_pairs);
    double error = 0.0;
    for (Index begin = 0; begin < num_pairs; begin += kCheckBlock) {
        const Index count = std::min(kCheckBlock, num_pairs - begin);
        const auto block = vectors.middleCols(begin, count);
        MatrixXd gram = block.transpose() * block;
        gram.diagonal().array() -= 1.0;
        error = std::max(error, gram.cwiseAbs().maxCoeff());
        // (lambda_i - lambda_j) v_i . v_j = r_i . v_j - v_i . r_j: far apart, residuals suffice.
        for (Index i = 0; i < begin; ++i) {
            for (Index j = begin; j < begin + count; ++j) {
                const std::size_t a = static_cast<std::size_t>(i);
                const std::size_t b = static_cast<std::size_t>(j);
                const double gap = pairs.values[b] - pairs.values[a];
                if (pairs.residuals[a] + pairs.residuals[b] <= kOrthonormal * gap) continue;
                error = std::max(error, std::abs(vectors.col(i).dot(vectors.col(j))));
            }
        }
    }
    return error;
}

void require_orthonormal(const ConnectedPairs& pairs, std::size_t size) {
    const double error = orthonormality_error(pairs, size);
    if (error <= kOrthonormal) return;
    throw NumericalError("eigensolver: eigenvectors are orthonormal only to " + scientific(error));
}

void require_small_residuals(const ConnectedPairs& pairs, const Laplacian& laplacian,
                             double tolerance) {
    for (std::size_t j = 0; j < pairs.values.size(); ++j) {
        if (pairs.residuals[j] <= tolerance * laplacian.norm_bound()) continue;
        throw NumericalError("eigensolver: the residual of eigenpair " + std::to_string(j) +
                             " is " + scientific(pairs.residuals[j] / laplacian.norm_bound()) +
                             " of the norm");
    }
}

ConnectedPairs solve_dense(const Laplacian& laplacian, const SpectrumRequest& request,
                           const EigenOptions& options, const Executor& executor) {
    const Index size = static_cast<Index>(laplacian.size());
    MatrixXd matrix = MatrixXd::Zero(size, size);
    for (std::size_t i = 0; i < laplacian.size(); ++i) {
        const Index row = static_cast<Index>(i);
        matrix(row, row) = laplacian.diagonal()[i];
        const auto columns = laplacian.row_columns(i);
        const auto values = laplacian.row_values(i);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            matrix(row, static_cast<Index>(columns[k])) = values[k];
        }
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
    if (solver.info() != Eigen::Success) {
        throw NumericalError("eigensolver: the dense solver did not converge");
    }
    const auto& values = solver.eigenvalues();
    const auto num_below = std::count_if(values.begin(), values.end(),
                                         [&](double value) { return value < request.limit; });
    std::vector<std::uint32_t> order(laplacian.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    ConnectedPairs pairs = finish(laplacian, solver.eigenvectors().leftCols(num_below), order,
                                  request.max_count, executor);
    require_orthonormal(pairs, laplacian.size());
    require_small_residuals(pairs, laplacian, options.tolerance);
    return pairs;
}

/// The known vector of length 1 with L x = 0, in the order of the factor.
std::vector<double> null_vector(const Laplacian& laplacian, std::span<const std::uint32_t> order) {
    std::vector<double> vector(order.size());
    double squared = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        vector[i] = laplacian.null_vector()[order[i]];
        squared += vector[i] * vector[i];
    }
    for (double& value : vector) value /= std::sqrt(squared);
    return vector;
}

/// Against which others the pairs of a slice are made orthogonal once more.
enum class Against : std::uint8_t { the_slice_before, all_before };

/// The null vector and the pairs of all slices, side by side.
MatrixXd join(const std::vector<double>& null_vector, const std::vector<SlicePairs>& found,
              Against against) {
    const Index size = static_cast<Index>(null_vector.size());
    Index total = 1;
    for (const SlicePairs& slice : found) total += static_cast<Index>(slice.values.size());
    MatrixXd vectors(size, total);
    vectors.col(0) = Eigen::Map<const VectorXd>(null_vector.data(), size);
    Index previous = 0;
    Index begin = 1;
    for (const SlicePairs& slice : found) {
        const Index count = static_cast<Index>(slice.values.size());
        if (count == 0) continue;
        auto block = vectors.middleCols(begin, count);
        block = Eigen::Map<const MatrixXd>(slice.vectors.data(), size, count);
        // Neighbours on either side of a mark were found by two runs, each with its own error.
        const auto before = vectors.middleCols(previous, begin - previous);
        const MatrixXd along = before.transpose() * block;
        block.noalias() -= before * along;
        block.colwise().normalize();
        previous = against == Against::all_before ? 0 : begin;
        begin += count;
    }
    return vectors;
}

ConnectedPairs solve_slices(const Laplacian& laplacian, const SpectrumRequest& request,
                            const EigenOptions& options, std::uint64_t seed,
                            const Executor& executor) {
    Random random(seed);
    ShiftedFactor factor(laplacian);
    const std::vector<SpectrumSlice> slices = plan_slices(laplacian, factor, request, random);
    const std::vector<double> known = null_vector(laplacian, factor.order());
    std::vector<SlicePairs> found(slices.size());
    parallel_for(executor, slices.size(), 1, [&](std::size_t i, std::size_t) {
        SpectrumSlice slice = slices[i];
        // The first slice holds the null vector, which is known.
        if (i == 0) --slice.num_wanted;
        if (slice.num_wanted == 0) return;
        Random own = random.fork(i);
        ShiftedFactor shifted(factor);
        slice = place_shift(slice, shifted, own);
        const double max_residual = 0.1 * options.tolerance * laplacian.norm_bound();
        found[i] = find_slice_pairs(shifted, slice, known, max_residual, own);
    });
    std::size_t num_wanted = 0;
    std::size_t num_found = 1;
    for (const SpectrumSlice& slice : slices) num_wanted += slice.num_wanted;
    for (const SlicePairs& pairs : found) num_found += pairs.values.size();
    if (num_found != num_wanted) {
        throw NumericalError("eigensolver: " + std::to_string(num_found) + " of " +
                             std::to_string(num_wanted) + " eigenpairs found");
    }
    const auto joined = [&](Against against) {
        return finish(laplacian, join(known, found, against), factor.order(), request.max_count,
                      executor);
    };
    ConnectedPairs pairs = joined(Against::the_slice_before);
    if (orthonormality_error(pairs, laplacian.size()) > kOrthonormal) {
        // Where weights span many decades, whole slices lie within rounding errors of each other.
        pairs = joined(Against::all_before);
        require_orthonormal(pairs, laplacian.size());
    }
    require_small_residuals(pairs, laplacian, options.tolerance);
    return pairs;
}

}  // namespace

ConnectedPairs solve_connected(const Laplacian& laplacian, const SpectrumRequest& request,
                               const EigenOptions& options, const Executor& executor) {
    if (laplacian.size() == 0 || request.max_count == 0 || !(request.limit > 0.0)) return {};
    if (laplacian.size() <= kDenseSize) return solve_dense(laplacian, request, options, executor);
    for (std::uint64_t attempt = 0;; ++attempt) {
        try {
            return solve_slices(laplacian, request, options, options.seed + attempt, executor);
        } catch (const NumericalError&) {
            // A shift may have come too close to an eigenvalue: others are drawn next time.
            if (attempt + 1 == kMaxAttempts) throw;
        }
    }
}

}  // namespace quadcut
