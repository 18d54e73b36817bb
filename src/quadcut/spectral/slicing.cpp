// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/slicing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
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

/// Below this size, and where most of the spectrum is wanted, a dense solver is faster.
constexpr std::size_t kDenseSize = 64;
/// Pairs of one slice at most, unless they are (nearly) one multiple eigenvalue.
constexpr std::size_t kSlicePairs = 32;
/// Share of the norm: a narrower interval is not divided further.
constexpr double kNarrow = 1e-10;
/// A slice is zoomed into this many times at most.
constexpr int kMaxZooms = 12;
constexpr int kMaxProbes = 200;
constexpr int kMaxAttempts = 3;
constexpr double kOrthonormal = 1e-8;
constexpr Index kCheckBlock = 32;

/// A place in the spectrum and the number of eigenvalues below it.
struct Mark {
    double at = 0.0;
    std::size_t num_below = 0;
};

/// Two marks, and how many of the pairs between them are wanted.
struct Interval {
    Mark low;
    Mark high;
    std::size_t num_wanted = 0;
};

class Slicer {
public:
    Slicer(const Laplacian& laplacian, const EigenOptions& options, std::uint64_t seed)
        : laplacian_(laplacian),
          options_(options),
          random_(seed),
          factor_(laplacian),
          narrow_(kNarrow * laplacian.norm_bound()) {
        const auto order = factor_.order();
        null_vector_.resize(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            null_vector_[i] = laplacian.null_vector()[order[i]];
        }
        const double length = std::sqrt(std::inner_product(null_vector_.begin(), null_vector_.end(),
                                                           null_vector_.begin(), 0.0));
        for (double& value : null_vector_) value /= length;
    }

    /// The pairs wanted; vectors as columns, in the order of the factor.
    struct Found {
        std::vector<double> values;
        MatrixXd vectors;
        std::size_t num_wanted = 0;
    };
    Found find(const SpectrumRequest& request, const Executor& executor) {
        std::vector<Interval> intervals;
        for (const Interval& part : choose_range(request)) divide(part, intervals);
        std::vector<SlicePairs> slices(intervals.size());
        parallel_for(executor, intervals.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) slices[i] = solve_slice(intervals[i], i);
        });
        return join(slices, intervals);
    }

    [[nodiscard]] std::span<const std::uint32_t> order() const { return factor_.order(); }

private:
    [[nodiscard]] Mark mark(double at) { return {at, factor_.factorize(at)}; }

    /// The end of the wanted part of the spectrum: one interval from 0 to a mark with as many
    /// eigenvalues below it as wanted or a few more; or two, the second a narrow one inside a
    /// multiple eigenvalue of which not all copies are wanted.
    std::vector<Interval> choose_range(const SpectrumRequest& request) {
        const std::size_t size = laplacian_.size();
        const Mark zero{0.0, 0};
        Mark high{1.001 * laplacian_.norm_bound(), size};
        if (request.limit < high.at) high = mark(request.limit);
        const std::size_t wanted = std::min(request.max_count, high.num_below);
        if (high.num_below <= request.max_count) return {{zero, high, wanted}};

        const std::size_t slack = 2 + wanted / 8;
        const auto trace =
            std::accumulate(laplacian_.diagonal().begin(), laplacian_.diagonal().end(), 0.0);
        // Weyl's law for a uniform grid: lambda_k = pi k / size * diagonal entry.
        double guess = std::numbers::pi * static_cast<double>(wanted) * trace /
                       (static_cast<double>(size) * static_cast<double>(size));
        Mark low = zero;
        for (int probe = 0; probe < kMaxProbes; ++probe) {
            if (high.at - low.at <= narrow_) break;
            const Mark middle = mark(inside(low, high, guess, probe));
            if (middle.num_below < wanted) {
                low = middle;
            } else {
                high = middle;
            }
            if (high.num_below >= wanted && high.num_below <= wanted + slack) {
                return {{zero, high, high.num_below}};
            }
            const double target = static_cast<double>(wanted) + 0.5 * static_cast<double>(slack);
            const double rank = target - static_cast<double>(low.num_below);
            const double ranks = static_cast<double>(high.num_below - low.num_below);
            if (high.num_below == size) {
                guess = middle.at * target /
                        static_cast<double>(std::max<std::size_t>(middle.num_below, 1));
            } else {
                guess = low.at + (high.at - low.at) * rank / ranks;
            }
        }
        return {{zero, low, low.num_below}, {low, high, wanted - low.num_below}};
    }

    /// `guess`, kept well inside the bracket; every third probe halves it.
    [[nodiscard]] double inside(const Mark& low, const Mark& high, double guess, int probe) {
        const double width = high.at - low.at;
        const double share = probe % 3 == 2 ? 0.5 : 0.02;
        // Not on the spot where a symmetric map has an eigenvalue.
        const double jitter = random_.uniform(0.0, 0.001) * width;
        return std::clamp(guess, low.at + share * width, high.at - share * width) + jitter;
    }

    void divide(const Interval& whole, std::vector<Interval>& parts) {
        const std::size_t count = whole.high.num_below - whole.low.num_below;
        if (count == 0) return;
        if (count <= kSlicePairs || whole.high.at - whole.low.at <= narrow_) {
            parts.push_back(whole);
            return;
        }
        const std::size_t num_parts = (count + kSlicePairs - 1) / kSlicePairs;
        const double share = static_cast<double>((num_parts + 1) / 2) /
                             static_cast<double>(num_parts + num_parts % 2);
        const double width = whole.high.at - whole.low.at;
        const Mark middle = mark(whole.low.at + (share + random_.uniform(-0.01, 0.01)) * width);
        divide({whole.low, middle, middle.num_below - whole.low.num_below}, parts);
        divide({middle, whole.high, whole.high.num_below - middle.num_below}, parts);
    }

    [[nodiscard]] SlicePairs solve_slice(Interval interval, std::size_t stream) const {
        // The null vector is known.
        const bool holds_zero = interval.low.num_below == 0;
        if (holds_zero) --interval.num_wanted;
        if (interval.num_wanted == 0) return {};
        ShiftedFactor factor(factor_);
        // Zoom in until there are eigenvalues on both sides of the shift.
        double shift = 0.0;
        for (int zoom = 0; zoom < kMaxZooms; ++zoom) {
            shift = 0.5 * (interval.low.at + interval.high.at);
            const std::size_t num_below = factor.factorize(shift);
            if (interval.high.at - interval.low.at <= narrow_) break;
            if (num_below == interval.high.num_below && zoom + 1 < kMaxZooms) {
                interval.high.at = shift;
            } else if (num_below == interval.low.num_below && zoom + 1 < kMaxZooms) {
                interval.low.at = shift;
            } else {
                break;
            }
        }
        const double low = holds_zero ? -laplacian_.norm_bound() : interval.low.at;
        LanczosOptions lanczos;
        lanczos.max_residual = 0.1 * options_.tolerance * laplacian_.norm_bound();
        lanczos.seed = random_.fork(stream + 1).bits();
        return find_slice_pairs(factor, shift, {low, interval.high.at, interval.num_wanted},
                                null_vector_, lanczos);
    }

    [[nodiscard]] Found join(const std::vector<SlicePairs>& slices,
                             const std::vector<Interval>& intervals) const {
        const Index size = static_cast<Index>(null_vector_.size());
        Found found;
        for (const Interval& interval : intervals) found.num_wanted += interval.num_wanted;
        Index total = 1;
        for (const SlicePairs& slice : slices) total += static_cast<Index>(slice.values.size());
        found.vectors.resize(size, total);
        found.values.push_back(0.0);
        found.vectors.col(0) = Eigen::Map<const VectorXd>(null_vector_.data(), size);
        Index begin = 1;
        Index previous = 0;
        for (const SlicePairs& slice : slices) {
            const Index count = static_cast<Index>(slice.values.size());
            if (count == 0) continue;
            found.values.insert(found.values.end(), slice.values.begin(), slice.values.end());
            auto block = found.vectors.middleCols(begin, count);
            block = Eigen::Map<const MatrixXd>(slice.vectors.data(), size, count);
            // Pairs of one cluster may have been found by two slices, each with its own error.
            const auto before = found.vectors.middleCols(previous, begin - previous);
            const MatrixXd along = before.transpose() * block;
            block.noalias() -= before * along;
            block.colwise().normalize();
            previous = begin;
            begin += count;
        }
        return found;
    }

    const Laplacian& laplacian_;
    const EigenOptions& options_;
    Random random_;
    ShiftedFactor factor_;
    double narrow_;
    std::vector<double> null_vector_;
};

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

/// Throws NumericalError unless residuals are small and vectors orthonormal.
void check(const ConnectedPairs& pairs, const Laplacian& laplacian, double tolerance) {
    const double max_residual = tolerance * laplacian.norm_bound();
    for (std::size_t j = 0; j < pairs.values.size(); ++j) {
        if (pairs.residuals[j] <= max_residual) continue;
        throw NumericalError("eigensolver: the residual of eigenpair " + std::to_string(j) +
                             " is " + std::to_string(pairs.residuals[j] / laplacian.norm_bound()) +
                             " of the norm");
    }
    const Index size = static_cast<Index>(laplacian.size());
    const Index num_pairs = static_cast<Index>(pairs.values.size());
    const Eigen::Map<const MatrixXd> vectors(pairs.vectors.data(), size, num_pairs);
    const auto require = [](double error) {
        if (error <= kOrthonormal) return;
        throw NumericalError("eigensolver: eigenvectors are orthonormal only to " +
                             std::to_string(error));
    };
    for (Index begin = 0; begin < num_pairs; begin += kCheckBlock) {
        const Index count = std::min(kCheckBlock, num_pairs - begin);
        const auto block = vectors.middleCols(begin, count);
        MatrixXd gram = block.transpose() * block;
        gram.diagonal().array() -= 1.0;
        require(gram.cwiseAbs().maxCoeff());
        // (lambda_i - lambda_j) v_i . v_j = r_i . v_j - v_i . r_j: far apart, residuals suffice.
        for (Index i = 0; i < begin; ++i) {
            for (Index j = begin; j < begin + count; ++j) {
                const std::size_t a = static_cast<std::size_t>(i);
                const std::size_t b = static_cast<std::size_t>(j);
                const double gap = pairs.values[b] - pairs.values[a];
                if (pairs.residuals[a] + pairs.residuals[b] <= kOrthonormal * gap) continue;
                require(std::abs(vectors.col(i).dot(vectors.col(j))));
            }
        }
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
    check(pairs, laplacian, options.tolerance);
    return pairs;
}

ConnectedPairs attempt(const Laplacian& laplacian, const SpectrumRequest& request,
                       const EigenOptions& options, std::uint64_t seed, const Executor& executor) {
    Slicer slicer(laplacian, options, seed);
    const Slicer::Found found = slicer.find(request, executor);
    if (static_cast<std::size_t>(found.vectors.cols()) != found.num_wanted) {
        throw NumericalError("eigensolver: " + std::to_string(found.vectors.cols()) + " of " +
                             std::to_string(found.num_wanted) + " eigenpairs found");
    }
    ConnectedPairs pairs =
        finish(laplacian, found.vectors, slicer.order(), request.max_count, executor);
    check(pairs, laplacian, options.tolerance);
    return pairs;
}

}  // namespace

ConnectedPairs solve_connected(const Laplacian& laplacian, const SpectrumRequest& request,
                               const EigenOptions& options, const Executor& executor) {
    if (laplacian.size() == 0 || request.max_count == 0 || !(request.limit > 0.0)) return {};
    if (laplacian.size() <= kDenseSize) return solve_dense(laplacian, request, options, executor);
    for (std::uint64_t number = 0;; ++number) {
        try {
            return attempt(laplacian, request, options, options.seed + number, executor);
        } catch (const NumericalError&) {
            // A shift may have come too close to an eigenvalue: others are drawn next time.
            if (number + 1 == kMaxAttempts) throw;
        }
    }
}

}  // namespace quadcut
