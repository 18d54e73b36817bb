// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// The factorisation P (L - sigma I) P^T = M D M^T of a Laplacian L, M unit lower triangular, D
/// diagonal, P a permutation that keeps M sparse (approximate minimum degree). It counts the
/// eigenvalues below sigma and applies the inverse.
class ShiftedFactor {
public:
    /// Right-hand sides of one solve.
    static constexpr int kWidth = 2;

    /// Finds P; nothing is factorised yet. On the graph of a floor plan M has few more entries than
    /// L, and the cost is close to linear.
    explicit ShiftedFactor(const Laplacian& laplacian);
    ~ShiftedFactor();

    /// order()[i] is the row of L that stands in place i.
    [[nodiscard]] std::span<const int> order() const;

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

    /// Overwrites `block`, row-major with kWidth columns, its rows in the order of P, with
    /// (L - sigma I)^-1 block. @pre factorize() has found a factorisation.
    void solve(std::span<double> block) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace quadcut
