// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#if __has_include(<Spectra/SymEigsShiftSolver.h>)
#define QUADCUT_HAS_SPECTRA 1

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsShiftSolver.h>

#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// (L - sigma I)^-1 for Spectra, by the same factorisation as our own solver's.
class InverseLaplacian {
public:
    using Scalar = double;

    explicit InverseLaplacian(const Laplacian& laplacian)
        : matrix_(static_cast<int>(laplacian.size()), static_cast<int>(laplacian.size())) {
        std::vector<Eigen::Triplet<double, int>> entries;
        for (std::size_t i = 0; i < laplacian.size(); ++i) {
            const int row = static_cast<int>(i);
            entries.emplace_back(row, row, laplacian.diagonal()[i]);
            const auto columns = laplacian.row_columns(i);
            const auto values = laplacian.row_values(i);
            for (std::size_t k = 0; k < columns.size(); ++k) {
                if (columns[k] < i) {
                    entries.emplace_back(row, static_cast<int>(columns[k]), values[k]);
                }
            }
        }
        matrix_.setFromTriplets(entries.begin(), entries.end());
    }

    [[nodiscard]] Eigen::Index rows() const { return matrix_.rows(); }
    [[nodiscard]] Eigen::Index cols() const { return matrix_.cols(); }
    void set_shift(double sigma) {
        factor_.setShift(-sigma);
        factor_.compute(matrix_);
    }
    void perform_op(const double* x, double* y) const {
        Eigen::Map<Eigen::VectorXd>(y, rows()) =
            factor_.solve(Eigen::Map<const Eigen::VectorXd>(x, rows()));
    }

private:
    Eigen::SparseMatrix<double> matrix_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

struct SpectraAnswer {
    std::vector<double> values;
    /// Column j belongs to values[j].
    Eigen::MatrixXd vectors;
    /// What the solver says of itself.
    bool is_successful = false;
};

/// The smallest eigenvalues, ascending, with the customary Krylov dimension and a shift just below
/// zero.
inline SpectraAnswer solve_with_spectra(const Laplacian& laplacian, std::size_t count) {
    InverseLaplacian inverse(laplacian);
    const auto wanted = static_cast<Eigen::Index>(count);
    const Eigen::Index krylov =
        std::min(inverse.rows(), std::max<Eigen::Index>(2 * wanted + 1, 20));
    Spectra::SymEigsShiftSolver<InverseLaplacian> solver(inverse, wanted, krylov,
                                                         -1e-6 * laplacian.norm_bound());
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10);
    SpectraAnswer answer;
    answer.is_successful = solver.info() == Spectra::CompInfo::Successful;
    // By the inverse operator's values, largest first.
    const Eigen::VectorXd values = solver.eigenvalues().reverse();
    answer.values.assign(values.begin(), values.end());
    // The eigenvectors are part of the answer, and of its cost.
    answer.vectors = solver.eigenvectors().rowwise().reverse();
    if (answer.vectors.cols() != values.size()) answer.is_successful = false;
    return answer;
}

}  // namespace quadcut

#endif
