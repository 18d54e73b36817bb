// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/shifted_factor.hpp"

#include <limits>
#include <stdexcept>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace quadcut {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct ShiftedFactor::State {
    SparseMatrix upper;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    /// Takes an upper triangle as it is, and a lower one through a copy.
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt;
    double shift = 0.0;
    Eigen::VectorXd pivots;
};

ShiftedFactor::ShiftedFactor(const Laplacian& laplacian) : state_(std::make_unique<State>()) {
    if (laplacian.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw std::logic_error("ShiftedFactor: the matrix is too large");
    }
    const int size = static_cast<int>(laplacian.size());
    // The lower triangle by columns, which are the rows of L.
    SparseMatrix lower(size, size);
    for (int j = 0; j < size; ++j) {
        const std::size_t row = static_cast<std::size_t>(j);
        lower.startVec(j);
        lower.insertBack(j, j) = laplacian.diagonal()[row];
        const auto columns = laplacian.row_columns(row);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (columns[k] < row) continue;
            lower.insertBack(static_cast<int>(columns[k]), j) = laplacian.row_values(row)[k];
        }
    }
    lower.finalize();

    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), state_->order);
    state_->upper.resize(size, size);
    state_->upper.selfadjointView<Eigen::Upper>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(state_->order.inverse());
    state_->ldlt.analyzePattern(state_->upper);
}

ShiftedFactor::~ShiftedFactor() = default;

std::span<const int> ShiftedFactor::order() const {
    return {state_->order.indices().data(), static_cast<std::size_t>(state_->order.size())};
}

ShiftedFactor::Inertia ShiftedFactor::factorize(double shift) {
    state_->shift = shift;
    state_->ldlt.setShift(-shift);
    state_->ldlt.factorize(state_->upper);
    const Inertia failed{0, std::numeric_limits<double>::infinity()};
    if (state_->ldlt.info() != Eigen::Success) return failed;
    state_->pivots = state_->ldlt.vectorD();
    const SparseMatrix& factor = state_->ldlt.matrixL().nestedExpression();
    const Eigen::Map<const Eigen::ArrayXd> entries(factor.valuePtr(), factor.nonZeros());
    const double growth = entries.size() == 0 ? 0.0 : entries.abs().maxCoeff();
    if (!state_->pivots.allFinite() || !entries.allFinite() ||
        state_->pivots.cwiseAbs().minCoeff() == 0.0) {
        return failed;
    }
    return {static_cast<std::size_t>((state_->pivots.array() < 0.0).count()), growth};
}

double ShiftedFactor::shift() const { return state_->shift; }

void ShiftedFactor::solve(std::span<double> block) const {
    const SparseMatrix& factor = state_->ldlt.matrixL().nestedExpression();
    if (block.size() != static_cast<std::size_t>(state_->order.size()) * kWidth) {
        throw std::logic_error("ShiftedFactor::solve: the block has the wrong size");
    }
    // One pass down the columns of M, one up. Rows of the block are contiguous, so that the inner
    // loop runs over right-hand sides: that is where vector instructions are.
    using Row = Eigen::Array<double, 1, kWidth>;
    const auto row = [&](Eigen::Index i) { return Eigen::Map<Row>(block.data() + i * kWidth); };
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
        Row value = row(j) / state_->pivots[j];
        for (int k = column_begin[j]; k < column_begin[j + 1]; ++k) {
            value -= values[k] * row(rows[k]);
        }
        row(j) = value;
    }
}

}  // namespace quadcut
