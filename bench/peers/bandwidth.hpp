// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut::peers {

/// Bytes a second that this machine moves between memory and its cores, over arrays of 256 MB.
struct Bandwidth {
    /// The sum of an array.
    double read = 0.0;
    /// a = b + c d (McCalpin's triad), 24 bytes an element.
    double triad = 0.0;
};
/// Bytes a second that the product L x moves at least: each entry (value and column), and of each
/// row the diagonal entry, its place and its length, x and the result, once.
struct Product {
    double ms = 0.0;
    double bytes = 0.0;
};

/// The best of many calls of each, in turns: a machine that others use has other bandwidths a
/// second later.
struct ProductBesideBandwidth {
    Bandwidth bandwidth;
    Product product;
};
[[nodiscard]] ProductBesideBandwidth measure_product(const Laplacian& laplacian,
                                                     std::size_t num_entries,
                                                     const Executor& executor);

}  // namespace quadcut::peers
