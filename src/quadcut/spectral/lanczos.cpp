// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/lanczos.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

#include <Eigen/Dense>

namespace quadcut {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kBlock = ShiftedFactor::kWidth;
using Lengths = Eigen::Matrix<double, 1, kBlock>;
/// A block of vectors, row by row: one instruction takes what stands in a row.
using Block = Eigen::Matrix<double, Eigen::Dynamic, kBlock, Eigen::RowMajor>;
using Row = Eigen::Array<double, 1, kBlock>;

/// Rows of all vectors that stay in the cache, and that are one thread's at a time.
constexpr Index kBandRows = 4096;
/// Shorter vectors are one thread's work: their bands take less time than threads take to meet,
/// and on a busy machine each meeting may cost a time slice.
constexpr Index kMinSharedRows = 65536;
/// Vectors between two looks at the Ritz values.
constexpr Index kCheckEvery = 4;
/// Vectors of the basis, beside 5/4 of the pairs: more take longer to reorthogonalise, fewer
/// converge more slowly.
constexpr Index kExtraVectors = 36;
constexpr Index kMaxVectors = 256;
/// Restarts without a pair before giving up.
constexpr int kMaxBarren = 20;
/// A column of which no larger share is left is rounding error.
constexpr double kDependent = 1e-12;
/// One of which no larger share is left is made orthogonal once more.
constexpr double kShrunk = 1e-3;

/// Lanczos with A = (L - sigma I)^-1 on the complement of the known vectors and of what is found.
class BlockLanczos {
public:
    BlockLanczos(const ShiftedFactor& factor, std::span<const double> known, Index num_missing,
                 double max_residual, Random& random, const Executor& executor)
        : factor_(factor),
          max_residual_(max_residual),
          random_(random),
          executor_(factor.order().size() < kMinSharedRows ? Executor{1} : executor),
          num_missing_(num_missing),
          num_known_(static_cast<Index>(known.size() / factor.order().size())) {
        const Index size = static_cast<Index>(factor.order().size());
        const Index capacity =
            std::min(kMaxVectors, num_missing + num_missing / 4 + kExtraVectors) / kBlock * kBlock;
        projected_ = MatrixXd::Zero(capacity, capacity);
        all_.resize(size, num_known_ + num_missing + capacity + kBlock);
        const Eigen::Map<const MatrixXd> given(known.data(), size, num_known_);
        for (Index i = 0; i < size; ++i) {
            all_.row(i).head(num_known_) = given.row(factor.order()[i]);
        }
        next_ = Block::Zero(size, kBlock);
        orthonormalize_next(Lengths::Ones());
    }

    [[nodiscard]] LanczosPairs find() {
        Index next_check = num_missing_ + kCheckEvery;
        for (int num_barren = 0; num_missing_ > 0 && num_barren < kMaxBarren;) {
            step();
            const bool is_last = num_basis() + kBlock > projected_.cols() || next_.isZero();
            if (!is_last && num_basis() < next_check) continue;
            next_check = num_basis() + kCheckEvery;
            const Index num_converged = std::min(num_missing_, find_ritz_pairs());
            if (!is_last && num_converged < num_missing_) continue;
            restart(num_converged);
            num_barren = num_converged == 0 ? num_barren + 1 : 0;
            next_check = num_missing_ + kCheckEvery;
        }
        return unpack();
    }

private:
    [[nodiscard]] Index num_basis() const { return num_ - num_fixed_; }

    void for_each_band(const std::function<void(Index first, Index count)>& body) const {
        parallel_for(executor_, all_.rows(), kBandRows, [&](std::size_t first, std::size_t last) {
            body(static_cast<Index>(first), static_cast<Index>(last - first));
        });
    }

    /// Calls `body(first, width)` for groups of four vectors and for what is left one by one.
    template <typename Body>
    static void for_each_group(Index count, const Body& body) {
        constexpr Index kGroup = 4;
        Index j = 0;
        for (; j + kGroup <= count; j += kGroup) body(j, std::integral_constant<Index, kGroup>());
        for (; j < count; ++j) body(j, std::integral_constant<Index, 1>());
    }

    /// Takes what lies along the vectors from `first` on out of the next block, and returns it.
    /// Each vector is read twice from memory, for all columns of the block at once.
    Block orthogonalize_next(Index first) {
        const Index count = num_ - first;
        const Index num_bands = (all_.rows() + kBandRows - 1) / kBandRows;
        Block along_of_bands = Block::Zero(num_bands * count, kBlock);
        for_each_band([&](Index begin, Index rows) {
            for_each_group(count, [&](Index j, auto width) {
                const double* basis = &all_(begin, first + j);
                std::array<Row, width> sums;
                sums.fill(Row::Zero());
                for (Index i = 0; i < rows; ++i) {
                    const Row row = next_.row(begin + i);
                    for (Index k = 0; k < width; ++k) sums[k] += basis[k * all_.rows() + i] * row;
                }
                const Index place = begin / kBandRows * count + j;
                for (Index k = 0; k < width; ++k) along_of_bands.row(place + k) = sums[k];
            });
        });
        Block along = Block::Zero(count, kBlock);
        for (Index b = 0; b < num_bands; ++b) along += along_of_bands.middleRows(b * count, count);
        for_each_band([&](Index begin, Index rows) {
            for_each_group(count, [&](Index j, auto width) {
                const double* basis = &all_(begin, first + j);
                const Index stride = all_.rows();
                double* const block = next_.data() + begin * kBlock;
                std::array<Row, width> parts;
                for (Index k = 0; k < width; ++k) parts[k] = along.row(j + k);
                for (Index i = 0; i < rows; ++i) {
                    Eigen::Map<Row, Eigen::Aligned16> row(block + i * kBlock);
                    Row left = row;
                    for (Index k = 0; k < width; ++k) left -= basis[k * stride + i] * parts[k];
                    row = left;
                }
            });
        });
        return along;
    }

    /// Adds the next block to the basis and makes the one after it.
    void step() {
        factor_.solve({next_.data(), static_cast<std::size_t>(next_.size())});
        num_ += kBlock;
        const Lengths lengths = next_.colwise().norm();
        // The recurrence takes out what is large; rounding errors are left for later.
        const Block along = orthogonalize_next(first_coupled_);
        const Index row = first_coupled_ - num_fixed_;
        const Index last = num_basis() - kBlock;
        projected_.block(row, last, along.rows(), kBlock) = along;
        projected_.block(last, row, kBlock, along.rows()) = along.transpose();
        first_coupled_ = num_ - kBlock;
        orthonormalize_next(lengths);
    }

    /// Makes the next block orthonormal, and orthogonal to all before it. `lengths`: of its columns
    /// before anything was taken out. A column without a direction of its own gets a random one
    /// that is not coupled, or is zero when no dimension is left.
    void orthonormalize_next(Lengths lengths) {
        coupling_.setIdentity();
        bool again = true;
        for (int pass = 0; pass < 3 && again; ++pass) {
            (void)orthogonalize_next(0);
            again = false;
            MatrixXd triangle = MatrixXd::Zero(kBlock, kBlock);
            for (Index j = 0; j < kBlock; ++j) {
                auto column = next_.col(j);
                for (Index i = 0; i < j; ++i) {
                    triangle(i, j) = next_.col(i).dot(column);
                    column -= triangle(i, j) * next_.col(i);
                }
                const double length = column.norm();
                again = again || length <= kShrunk * lengths[j];
                if (length > kDependent * lengths[j]) {
                    triangle(j, j) = length;
                    column /= length;
                } else if (pass < 2) {
                    for (double& value : column) value = random_.uniform(-1.0, 1.0);
                    column.normalize();
                } else {
                    column.setZero();
                }
            }
            coupling_ = triangle * coupling_;
            lengths.setOnes();
        }
        all_.middleCols<kBlock>(num_) = next_;
    }

    /// Makes thetas_ and coordinates_, largest first; returns how many have converged before the
    /// first that has not.
    Index find_ritz_pairs() {
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
            projected_.topLeftCorner(num_basis(), num_basis()));
        thetas_ = solver.eigenvalues().reverse();
        coordinates_ = solver.eigenvectors().rowwise().reverse();
        const VectorXd residuals = (coupling_ * coordinates_.bottomRows<kBlock>()).colwise().norm();
        Index num_converged = 0;
        // Of the improved vector A x / theta: L's residual is A's over theta^2.
        while (num_converged < thetas_.size() && thetas_[num_converged] > 0.0 &&
               residuals[num_converged] <= max_residual_ * std::pow(thetas_[num_converged], 2)) {
            ++num_converged;
        }
        return num_converged;
    }

    /// Locks the first Ritz pairs, and makes some more of them the basis, all coupled with the next
    /// block. What is locked is improved by one application of A, which costs
    /// nothing: A x / theta is x + next * coupling * (last coordinates of x) / theta.
    void restart(Index num_locked) {
        const bool is_last = num_locked == num_missing_;
        const Index num_kept = num_locked + (is_last ? 0 : (num_basis() - num_locked) / 3);
        MatrixXd beyond = coupling_ * coordinates_.bottomRows<kBlock>().leftCols(num_locked);
        for (Index j = 0; j < num_locked; ++j) {
            beyond.col(j) /= thetas_[j];
            values_.push_back(factor_.shift() + 1.0 / thetas_[j]);
        }
        for_each_band([&](Index begin, Index count) {
            auto band = all_.middleRows(begin, count);
            MatrixXd kept =
                band.middleCols(num_fixed_, num_basis()) * coordinates_.leftCols(num_kept);
            kept.leftCols(num_locked) += next_.middleRows(begin, count) * beyond;
            band.middleCols(num_fixed_, num_kept) = kept;
        });
        num_ = num_fixed_ + num_kept;
        num_fixed_ += num_locked;
        num_missing_ -= num_locked;
        if (is_last) return;
        first_coupled_ = num_fixed_;
        projected_.setZero();
        projected_.diagonal().head(num_basis()) = thetas_.segment(num_locked, num_basis());
        orthonormalize_next(Lengths::Ones());
    }

    [[nodiscard]] LanczosPairs unpack() const {
        LanczosPairs pairs{values_, std::vector<double>(values_.size() * all_.rows())};
        Eigen::Map<MatrixXd> vectors(pairs.vectors.data(), all_.rows(), num_fixed_ - num_known_);
        for (Index j = 0; j < vectors.cols(); ++j) {
            for (Index i = 0; i < vectors.rows(); ++i) {
                vectors(factor_.order()[i], j) = all_(i, num_known_ + j);
            }
        }
        return pairs;
    }

    const ShiftedFactor& factor_;
    double max_residual_;
    Random& random_;
    Executor executor_;
    Index num_missing_;
    Index num_known_;
    /// Vectors known, and those with what is found; with the basis too. Then comes the next block.
    Index num_fixed_ = num_known_;
    Index num_ = num_known_;
    /// First vector that the next block is coupled with.
    Index first_coupled_ = num_known_;
    /// All vectors, in the order of the factor; behind the basis a copy of the next block.
    MatrixXd all_;
    Block next_;
    std::vector<double> values_;
    /// A basis = basis projected + next coupling (on the last block of the basis).
    MatrixXd projected_;
    Eigen::Matrix<double, kBlock, kBlock> coupling_;
    VectorXd thetas_;
    MatrixXd coordinates_;
};

}  // namespace

LanczosPairs find_smallest_pairs(const ShiftedFactor& factor, std::span<const double> known,
                                 std::size_t count, double max_residual, Random& random,
                                 const Executor& executor) {
    return BlockLanczos(factor, known, static_cast<Index>(count), max_residual, random, executor)
        .find();
}

}  // namespace quadcut
