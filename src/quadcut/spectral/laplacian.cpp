// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/laplacian.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "quadcut/graph/accelerator.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRowsPerChunk = 8192;

void check(const Graph& graph, LaplacianKind kind) {
    for (const double weight : graph.weights) {
        if (!(weight >= 0.0) || !std::isfinite(weight)) {
            throw std::logic_error("Laplacian: weights must be finite and not negative");
        }
    }
    if (kind != LaplacianKind::area) return;
    for (const double area : graph.area_m2) {
        if (!(area > 0.0) || !std::isfinite(area)) {
            throw std::logic_error("Laplacian: areas must be finite and positive");
        }
    }
}

}  // namespace

Laplacian::Laplacian(const Graph& graph, LaplacianKind kind) : kind_(kind) {
    check(graph, kind);
    const std::size_t num_nodes = graph.num_nodes();
    row_begin_.assign(1, 0);
    row_begin_.reserve(num_nodes + 1);
    columns_.reserve(graph.columns.size());
    values_.reserve(graph.columns.size());
    diagonal_.assign(num_nodes, 0.0);
    null_vector_.assign(num_nodes, 0.0);

    // The off-diagonal part of W, the sums of its rows, and what scales row i: 1 / null_vector[i].
    for (std::size_t i = 0; i < num_nodes; ++i) {
        const auto columns = graph.neighbours(i);
        const auto weights = graph.neighbour_weights(i);
        double loop = 0.0;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (columns[k] == i) loop += weights[k];
            if (columns[k] == i || weights[k] == 0.0) continue;
            columns_.push_back(columns[k]);
            values_.push_back(kind == LaplacianKind::unweighted ? 1.0 : weights[k]);
            diagonal_[i] += values_.back();
        }
        row_begin_.push_back(columns_.size());
        if (kind == LaplacianKind::degree) null_vector_[i] = std::sqrt(diagonal_[i] + loop);
        if (kind == LaplacianKind::unweighted) null_vector_[i] = std::sqrt(diagonal_[i]);
        if (kind == LaplacianKind::area) null_vector_[i] = std::sqrt(graph.area_m2[i]);
        // A node alone: its row of L is 0, so any vector is in the null space.
        if (null_vector_[i] == 0.0) null_vector_[i] = 1.0;
    }

    // Eq. (4): L = I - D^-1/2 W D^-1/2, in the form N^-1 (D' - W') N^-1 with loops cancelled, where
    // N is the diagonal of the null vector; so L_ii = 1 - w_ii / d_i.
    double largest_row = 0.0;
    for (std::size_t i = 0; i < num_nodes; ++i) {
        diagonal_[i] /= null_vector_[i] * null_vector_[i];
        double row_sum = diagonal_[i];
        for (std::size_t k = row_begin_[i]; k < row_begin_[i + 1]; ++k) {
            values_[k] = -values_[k] / (null_vector_[i] * null_vector_[columns_[k]]);
            row_sum -= values_[k];
        }
        largest_row = std::max(largest_row, row_sum);
    }
    if (!std::isfinite(largest_row)) throw std::logic_error("Laplacian: an entry overflows");
    if (kind != LaplacianKind::area) largest_row = std::min(largest_row, 2.0);
    norm_bound_ = largest_row > 0.0 ? largest_row : 1.0;
}

void Laplacian::apply(std::span<const double> x, std::span<double> result,
                      const Executor& executor) const {
    if (x.size() != size() || result.size() != size()) {
        throw std::logic_error("Laplacian::apply: a vector has the wrong length");
    }
    parallel_for(executor, size(), kRowsPerChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            double sum = diagonal_[i] * x[i];
            for (std::size_t k = row_begin_[i]; k < row_begin_[i + 1]; ++k) {
                sum += values_[k] * x[columns_[k]];
            }
            result[i] = sum;
        }
    });
}

void Laplacian::apply_block(std::span<const double> block, std::span<double> result,
                            const Executor& executor) const {
    if (block.empty() && result.empty()) return;
    if (size() == 0 || block.size() % size() != 0 || result.size() != block.size()) {
        throw std::logic_error("Laplacian::apply_block: a block has the wrong length");
    }
    Accelerator* const accelerator = executor.accelerator;
    if (accelerator != nullptr &&
        accelerator->multiply({diagonal_, row_begin_, columns_, values_}, block, result)) {
        return;
    }
    parallel_for(executor, block.size() / size(), 1, [&](std::size_t j, std::size_t) {
        apply(block.subspan(j * size(), size()), result.subspan(j * size(), size()));
    });
}

}  // namespace quadcut
