// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/lanczos.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace quadcut {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Index kBlock = 2;
constexpr Index kBandRows = 1024;
/// Pairs one start goes for.
constexpr Index kMaxAim = 64;
/// Steps between two looks at the Ritz values.
constexpr Index kCheckEvery = 2;
/// Vectors of one start at most, for each pair it goes for. Some 2.5 are the rule.
constexpr Index kBasisPerPair = 6;
/// Starts without a pair before giving up.
constexpr int kMaxBarren = 3;
/// A column of which no larger share is left is rounding error.
constexpr double kDependent = 1e-12;
/// One of which no larger share is left is made orthogonal once more.
constexpr double kShrunk = 1e-3;
/// Largest |A x - theta x| / |theta|: keeps vectors accurate and, squared, orthonormal.
constexpr double kMaxRelativeResidual = 1e-8;

/// Takes the components along the orthonormal columns of `basis` out of `block`. In bands of rows
/// that stay in the cache, and column by column: for so few columns a matrix product would spend
/// its time on packing the basis.
void orthogonalize(const Eigen::Ref<const MatrixXd>& basis, Eigen::Ref<MatrixXd> block) {
    if (basis.cols() == 0) return;
    const auto for_each_band = [&](const auto& body) {
        for (Index first = 0; first < basis.rows(); first += kBandRows) {
            const Index count = std::min(kBandRows, basis.rows() - first);
            for (Index j = 0; j < block.cols(); ++j) body(first, count, j);
        }
    };
    MatrixXd along = MatrixXd::Zero(basis.cols(), block.cols());
    for_each_band([&](Index first, Index count, Index j) {
        along.col(j).noalias() +=
            basis.middleRows(first, count).transpose() * block.col(j).segment(first, count);
    });
    for_each_band([&](Index first, Index count, Index j) {
        block.col(j).segment(first, count).noalias() -=
            basis.middleRows(first, count) * along.col(j);
    });
}

/// Lanczos with A = (L - shift I)^-1 on the complement of some vectors.
class BlockLanczos {
public:
    struct Ritz {
        VectorXd thetas;
        /// Coordinates in the basis, a column a pair.
        MatrixXd coordinates;
        /// |A x - theta x|.
        VectorXd residuals;
    };

    /// Begins with the columns of `first`, and random ones to fill the block. At most `capacity`
    /// vectors are made. Everything stays orthogonal to `deflated`, which is orthonormal.
    BlockLanczos(const ShiftedFactor& factor, const MatrixXd& deflated, const MatrixXd& first,
                 Index capacity, Random& random)
        : factor_(factor),
          random_(random),
          num_deflated_(deflated.cols()),
          num_dims_(deflated.rows() - deflated.cols()),
          all_(deflated.rows(), num_deflated_ + std::min(capacity, num_dims_)),
          projected_(MatrixXd::Zero(all_.cols() - num_deflated_, all_.cols() - num_deflated_)),
          next_(MatrixXd::Zero(deflated.rows(), std::min(kBlock, projected_.cols()))) {
        all_.leftCols(num_deflated_) = deflated;
        const Index given = std::min(first.cols(), next_.cols());
        next_.leftCols(given) = first.leftCols(given);
        orthonormalize_next(VectorXd::Ones(next_.cols()));
    }

    /// Appends the next block to the basis and makes the one after it. False if there is no room.
    bool step() {
        const Index width = next_.cols();
        if (width == 0 || num_basis_ + width > projected_.cols()) return false;
        MatrixXd image = apply_inverse(next_);
        const VectorXd lengths = image.colwise().norm();
        // The three-term recurrence takes out what is large; rounding errors are left for later.
        const MatrixXd diagonal = next_.transpose().lazyProduct(image);
        projected_.block(num_basis_, num_basis_, width, width) =
            0.5 * (diagonal + diagonal.transpose());
        image.noalias() -= next_.lazyProduct(diagonal);
        if (num_basis_ > 0) {
            const Index before = coupling_.cols();
            const Index begin = num_basis_ - before;
            image.noalias() -=
                all_.middleCols(num_deflated_ + begin, before).lazyProduct(coupling_.transpose());
            projected_.block(num_basis_, begin, width, before) = coupling_;
            projected_.block(begin, num_basis_, before, width) = coupling_.transpose();
        }
        all_.middleCols(num_deflated_ + num_basis_, width) = next_;
        num_basis_ += width;
        next_ = std::move(image);
        orthonormalize_next(lengths);
        return true;
    }

    [[nodiscard]] Ritz ritz() const {
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
            projected_.topLeftCorner(num_basis_, num_basis_));
        Ritz result{solver.eigenvalues(), solver.eigenvectors(), {}};
        result.residuals = (coupling_ * result.coordinates.bottomRows(coupling_.cols()))
                               .colwise()
                               .norm()
                               .transpose();
        return result;
    }

    /// Ritz vectors improved by one application of A, which costs nothing: A x / theta is
    /// x + next * coupling * (last coordinates of x) / theta.
    [[nodiscard]] MatrixXd vectors(const Ritz& ritz, const std::vector<Index>& chosen) const {
        MatrixXd coordinates(num_basis_, static_cast<Index>(chosen.size()));
        MatrixXd beyond(coupling_.rows(), coordinates.cols());
        for (Index i = 0; i < coordinates.cols(); ++i) {
            const Index j = chosen[static_cast<std::size_t>(i)];
            coordinates.col(i) = ritz.coordinates.col(j);
            beyond.col(i) = coupling_ * coordinates.col(i).tail(coupling_.cols()) / ritz.thetas[j];
        }
        MatrixXd result = all_.middleCols(num_deflated_, num_basis_) * coordinates;
        result.noalias() += next_ * beyond;
        return result;
    }

    [[nodiscard]] Index num_basis() const { return num_basis_; }

private:
    [[nodiscard]] MatrixXd apply_inverse(const MatrixXd& block) const {
        RowMajorMatrix rows = RowMajorMatrix::Zero(block.rows(), kBlock);
        rows.leftCols(block.cols()) = block;
        factor_.solve({rows.data(), static_cast<std::size_t>(rows.size())}, kBlock);
        return rows.leftCols(block.cols());
    }

    /// Makes next_ orthonormal, and orthogonal to all before it. `lengths`: of its columns before
    /// anything was taken out. A column without a direction of its own gets a random one that is
    /// not coupled. next_ is cut to the number of dimensions left.
    void orthonormalize_next(const VectorXd& lengths) {
        const auto basis = all_.leftCols(num_deflated_ + num_basis_);
        orthogonalize(basis, next_);
        const Index count = next_.cols();
        const Index width = std::min(count, num_dims_ - num_basis_);
        coupling_ = MatrixXd::Zero(count, count);
        for (Index j = 0; j < count; ++j) {
            auto column = next_.col(j);
            const Index num_before = std::min(j, width);
            const auto before = next_.leftCols(num_before);
            for (int pass = 0; pass < 2; ++pass) {
                const VectorXd along = before.transpose() * column;
                column.noalias() -= before * along;
                coupling_.col(j).head(num_before) += along;
            }
            if (j >= width) continue;
            const double length = column.norm();
            if (length <= kDependent * lengths[j]) {
                for (double& value : column) value = random_.uniform(-1.0, 1.0);
                column.normalize();
            } else {
                coupling_(j, j) = length;
                column /= length;
            }
            if (length > kShrunk * lengths[j]) continue;
            for (int pass = 0; pass < 2; ++pass) {
                orthogonalize(basis, column);
                orthogonalize(before, column);
                column.normalize();
            }
        }
        next_.conservativeResize(Eigen::NoChange, width);
        coupling_.conservativeResize(width, Eigen::NoChange);
    }

    const ShiftedFactor& factor_;
    Random& random_;
    Index num_deflated_;
    /// Dimensions of the complement.
    Index num_dims_;
    /// What is deflated, then the basis.
    MatrixXd all_;
    Index num_basis_ = 0;
    MatrixXd projected_;
    MatrixXd next_;
    /// A basis = basis projected + next_ coupling_ (on the last columns of the basis).
    MatrixXd coupling_;
};

/// Which Ritz pairs of the slice have converged, and which have not.
struct Sorted {
    std::vector<Index> converged;
    std::vector<Index> unconverged;
};

Sorted sort_out(const BlockLanczos::Ritz& ritz, double shift, const SpectrumSlice& slice,
                double max_residual) {
    Sorted result;
    // Rounding may put a small eigenvalue below zero.
    const double low = slice.low.num_below == 0 ? -slice.high.at : slice.low.at;
    for (Index j = 0; j < ritz.thetas.size(); ++j) {
        const double theta = ritz.thetas[j];
        if (theta == 0.0) continue;
        const double value = shift + 1.0 / theta;
        if (value < low || value >= slice.high.at) continue;
        // Of the improved vector A x / theta: L's residual is A's over theta^2.
        const double relative = ritz.residuals[j] / std::abs(theta);
        const bool good =
            relative <= kMaxRelativeResidual && relative / std::abs(theta) <= max_residual;
        (good ? result.converged : result.unconverged).push_back(j);
    }
    // By eigenvalue.
    std::sort(result.converged.begin(), result.converged.end(),
              [&](Index a, Index b) { return 1.0 / ritz.thetas[a] < 1.0 / ritz.thetas[b]; });
    return result;
}

void append_columns(MatrixXd& matrix, const MatrixXd& columns) {
    const Index before = matrix.cols();
    matrix.conservativeResize(Eigen::NoChange, before + columns.cols());
    matrix.rightCols(columns.cols()) = columns;
}

}  // namespace

SlicePairs find_slice_pairs(const ShiftedFactor& factor, const SpectrumSlice& slice,
                            std::span<const double> null_vector, double max_residual,
                            Random& random) {
    const Index size = static_cast<Index>(null_vector.size());
    const double shift = factor.shift();
    // Locked: the null vector, then the pairs found.
    MatrixXd locked = Eigen::Map<const VectorXd>(null_vector.data(), size);
    std::vector<double> values;
    MatrixXd first(size, 0);
    int num_barren = 0;
    while (values.size() < slice.num_wanted && locked.cols() < size && num_barren < kMaxBarren) {
        const Index missing = static_cast<Index>(slice.num_wanted - values.size());
        const Index aim = std::min(missing, kMaxAim);
        BlockLanczos lanczos(factor, locked, first, (kBasisPerPair + num_barren) * (aim + 10),
                             random);
        BlockLanczos::Ritz ritz;
        Sorted sorted;
        Index next_check = aim + aim / 4 + 2 * kBlock;
        bool more = true;
        while (more) {
            more = lanczos.step();
            if (more && lanczos.num_basis() < next_check) continue;
            ritz = lanczos.ritz();
            sorted = sort_out(ritz, shift, slice, max_residual);
            if (static_cast<Index>(sorted.converged.size()) >= missing) break;
            next_check = lanczos.num_basis() + kCheckEvery * kBlock;
        }
        if (static_cast<Index>(sorted.converged.size()) > missing) {
            sorted.converged.resize(static_cast<std::size_t>(missing));
        }
        for (const Index j : sorted.converged) values.push_back(shift + 1.0 / ritz.thetas[j]);
        num_barren = sorted.converged.empty() ? num_barren + 1 : 0;
        append_columns(locked, lanczos.vectors(ritz, sorted.converged));
        if (values.size() < slice.num_wanted) first = lanczos.vectors(ritz, sorted.unconverged);
    }

    std::vector<std::size_t> by_value(values.size());
    std::iota(by_value.begin(), by_value.end(), std::size_t{0});
    std::stable_sort(by_value.begin(), by_value.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    SlicePairs result;
    result.vectors.reserve(values.size() * null_vector.size());
    for (const std::size_t j : by_value) {
        result.values.push_back(values[j]);
        const auto column = locked.col(static_cast<Index>(j) + 1);
        result.vectors.insert(result.vectors.end(), column.begin(), column.end());
    }
    return result;
}

}  // namespace quadcut
