// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/options.hpp"

namespace quadcut {

/// The normalised Laplacian of a graph, a symmetric positive semidefinite matrix, seen as an
/// operator: a size and a product. Its zero eigenvalues are as many as the graph has components.
class Laplacian {
public:
    /// O(nodes + edges), and that much memory; the graph is not kept. Throws std::logic_error if a
    /// weight is negative or not finite, or (area) an area is not positive and finite. An edge of
    /// weight zero counts as none.
    Laplacian(const Graph& graph, LaplacianKind kind);

    [[nodiscard]] std::size_t size() const { return diagonal_.size(); }
    [[nodiscard]] LaplacianKind kind() const { return kind_; }

    /// result = L x; both of length size(), not overlapping. O(nodes + edges).
    void apply(std::span<const double> x, std::span<double> result,
               const Executor& executor = {}) const;

    /// The same for a block of vectors, one after the other. On the executor's accelerator when it
    /// takes the work; the bits are those of apply().
    void apply_block(std::span<const double> block, std::span<double> result,
                     const Executor& executor = {}) const;

    [[nodiscard]] std::span<const double> diagonal() const { return diagonal_; }
    /// An upper bound of the largest eigenvalue: the largest absolute row sum, at most 2 where the
    /// kind promises that. Positive: 1 for a matrix of zeros.
    [[nodiscard]] double norm_bound() const { return norm_bound_; }
    /// The vector x with L x = 0 of a connected graph: sqrt(d_i), sqrt(deg_i) or sqrt(area_i), not
    /// scaled. On any graph its restriction to each component is in the null space.
    [[nodiscard]] std::span<const double> null_vector() const { return null_vector_; }

    /// Row i without its diagonal entry: columns ascending, and values.
    [[nodiscard]] std::span<const std::uint32_t> row_columns(std::size_t i) const {
        return std::span(columns_).subspan(row_begin_[i], row_length_[i]);
    }
    [[nodiscard]] std::span<const double> row_values(std::size_t i) const {
        return std::span(values_).subspan(row_begin_[i], row_length_[i]);
    }

private:
    LaplacianKind kind_;
    /// In bands of rows, by length. The rows' entries are stored in this order.
    std::vector<std::uint32_t> row_order_;
    std::vector<std::size_t> row_begin_;
    std::vector<std::uint32_t> row_length_;
    std::vector<std::uint32_t> columns_;
    std::vector<double> values_;
    std::vector<double> diagonal_;
    std::vector<double> null_vector_;
    double norm_bound_ = 0.0;
};

}  // namespace quadcut
