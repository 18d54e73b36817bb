// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// The factorisation P (L - sigma I) P^T = M D M^T of a Laplacian L, M unit lower triangular, D
/// diagonal, P a permutation that keeps M sparse (approximate minimum degree). It counts the
/// eigenvalues below sigma and applies the inverse. Vectors are in the order of P.
class ShiftedFactor {
public:
    /// Finds P; nothing is factorised yet. On the graph of a floor plan M has few more entries than
    /// L, and the cost is close to linear.
    explicit ShiftedFactor(const Laplacian& laplacian);
    /// Another factorisation of the same matrix, that shares P with `other` and no more.
    ShiftedFactor(const ShiftedFactor& other);
    ShiftedFactor& operator=(const ShiftedFactor&) = delete;
    ~ShiftedFactor();

    /// order()[i] is the row of L that stands in place i.
    [[nodiscard]] std::span<const std::uint32_t> order() const;

    /// What a factorisation tells.
    struct Inertia {
        /// Eigenvalues of L below the shift: the negative entries of D (Sylvester's law).
        std::size_t num_below = 0;
        /// Largest entry of M in magnitude. There is no pivoting: errors are that many times the
        /// rounding errors of L. Infinite if there is no factorisation.
        double growth = 0.0;
    };
    Inertia factorize(double shift);
    [[nodiscard]] double shift() const;

    /// Overwrites `block`, row-major with `width` columns, with (L - sigma I)^-1 block. Width is a
    /// power of two of at most 16. @pre factorize() has been called.
    void solve(std::span<double> block, std::size_t width) const;

private:
    struct Matrix;
    struct Numeric;
    std::shared_ptr<const Matrix> matrix_;
    std::unique_ptr<Numeric> numeric_;
};

}  // namespace quadcut
