// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

namespace quadcut {

/// How a Laplacian is normalised. W: weights; D: diagonal of row sums of W; A: areas of the nodes.
enum class LaplacianKind : std::uint8_t {
    /// Eq. (4) as Shi and Malik mean it: I - D^-1/2 W D^-1/2. A self-loop enters W and D alike.
    /// Eigenvalues in [0, 2], without unit.
    degree,
    /// Eq. (4) as printed: 1 on the diagonal, -1 / sqrt(deg_i deg_j) beside it, deg = number of
    /// neighbours; loops and weights play no part. Eigenvalues in [0, 2], without unit.
    unweighted,
    /// A^-1/2 (D - W) A^-1/2; loops cancel. With border weights it discretises minus the Laplace
    /// operator of the free space: eigenvalues in 1/m2.
    area,
};

/// What is done to the rows of an embedding.
enum class RowScaling : std::uint8_t {
    /// Divided by the Laplacian's null vector, sqrt(d_i) or sqrt(area_i): so they are the rows of
    /// the eigenvectors of D^-1 (D - W) (Shi, Malik 2000; von Luxburg 2007), those of a component
    /// equal in the first.
    degree,
    /// As they are.
    none,
    /// Scaled to length 1 (Ng, Jordan, Weiss 2001); rows of zeros stay.
    unit_length,
};

}  // namespace quadcut
