// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/shifted_factor.hpp"

#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace quadcut {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Ldlt = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// One pass down the columns of M, one up. Rows of the block are contiguous, so that the inner
/// loop runs over right-hand sides: that is where vector instructions are.
template <int Width>
void solve_block(const SparseMatrix& factor, const Eigen::VectorXd& pivots, double* block) {
    using Row = Eigen::Array<double, 1, Width>;
    const auto row = [block](Eigen::Index i) { return Eigen::Map<Row>(block + i * Width); };
    const int* column_begin = factor.outerIndexPtr();
    const int* rows = factor.innerIndexPtr();
    const double* values = factor.valuePtr();
    for (Eigen::Index j = 0; j < factor.cols(); ++j) {
        const Row value = row(j);
        for (int k = column_begin[j]; k < column_begin[j + 1]; ++k) {
            row(rows[k]) -= values[k] * value;
        }
    }
    for (Eigen::Index j = factor.cols() - 1; j >= 0; --j) {
        Row value = row(j) / pivots[j];
        for (int k = column_begin[j]; k < column_begin[j + 1]; ++k) {
            value -= values[k] * row(rows[k]);
        }
        row(j) = value;
    }
}

}  // namespace

struct ShiftedFactor::Matrix {
    SparseMatrix lower;
    std::vector<std::uint32_t> order;
};

struct ShiftedFactor::Numeric {
    explicit Numeric(const SparseMatrix& lower) { ldlt.analyzePattern(lower); }
    Ldlt ldlt;
    double shift = 0.0;
    Eigen::VectorXd pivots;
};

ShiftedFactor::ShiftedFactor(const Laplacian& laplacian) {
    const std::size_t size = laplacian.size();
    if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw std::logic_error("ShiftedFactor: the matrix is too large");
    }
    std::vector<Eigen::Triplet<double, int>> entries;
    for (std::size_t i = 0; i < size; ++i) {
        const int row = static_cast<int>(i);
        entries.emplace_back(row, row, laplacian.diagonal()[i]);
        const auto columns = laplacian.row_columns(i);
        const auto values = laplacian.row_values(i);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (columns[k] < i) entries.emplace_back(row, static_cast<int>(columns[k]), values[k]);
        }
    }
    SparseMatrix lower(static_cast<int>(size), static_cast<int>(size));
    lower.setFromTriplets(entries.begin(), entries.end());

    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> old_from_new;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), old_from_new);
    auto matrix = std::make_shared<Matrix>();
    matrix->order.assign(old_from_new.indices().begin(), old_from_new.indices().end());
    matrix->lower.resize(lower.rows(), lower.cols());
    matrix->lower.selfadjointView<Eigen::Lower>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(old_from_new.inverse());
    numeric_ = std::make_unique<Numeric>(matrix->lower);
    matrix_ = std::move(matrix);
}

ShiftedFactor::ShiftedFactor(const ShiftedFactor& other)
    : matrix_(other.matrix_), numeric_(std::make_unique<Numeric>(matrix_->lower)) {}

ShiftedFactor::~ShiftedFactor() = default;

std::span<const std::uint32_t> ShiftedFactor::order() const { return matrix_->order; }

ShiftedFactor::Inertia ShiftedFactor::factorize(double shift) {
    numeric_->shift = shift;
    numeric_->ldlt.setShift(-shift);
    numeric_->ldlt.factorize(matrix_->lower);
    Inertia result{0, std::numeric_limits<double>::infinity()};
    if (numeric_->ldlt.info() != Eigen::Success) return result;
    numeric_->pivots = numeric_->ldlt.vectorD();
    const SparseMatrix& factor = numeric_->ldlt.matrixL().nestedExpression();
    const Eigen::Map<const Eigen::ArrayXd> entries(factor.valuePtr(), factor.nonZeros());
    if (!numeric_->pivots.allFinite() || !entries.allFinite()) return result;
    if ((numeric_->pivots.array() == 0.0).any()) return result;
    result.growth = entries.size() == 0 ? 0.0 : entries.abs().maxCoeff();
    result.num_below = static_cast<std::size_t>((numeric_->pivots.array() < 0.0).count());
    return result;
}

double ShiftedFactor::shift() const { return numeric_->shift; }

void ShiftedFactor::solve(std::span<double> block, std::size_t width) const {
    if (block.size() != matrix_->order.size() * width) {
        throw std::logic_error("ShiftedFactor::solve: the block has the wrong size");
    }
    const SparseMatrix& factor = numeric_->ldlt.matrixL().nestedExpression();
    switch (width) {
        case 1:
            return solve_block<1>(factor, numeric_->pivots, block.data());
        case 2:
            return solve_block<2>(factor, numeric_->pivots, block.data());
        case 4:
            return solve_block<4>(factor, numeric_->pivots, block.data());
        case 8:
            return solve_block<8>(factor, numeric_->pivots, block.data());
        case 16:
            return solve_block<16>(factor, numeric_->pivots, block.data());
        default:
            throw std::logic_error("ShiftedFactor::solve: width 1, 2, 4, 8 or 16 expected");
    }
}

}  // namespace quadcut
