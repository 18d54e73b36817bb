// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/laplacian.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "quadcut/spectral/accelerator.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRowsPerChunk = 8192;
/// Rows that are visited by length: equally long loops are what a processor foresees. So few that
/// their parts of the vectors stay in its cache; a divisor of the chunk.
constexpr std::ptrdiff_t kRowsPerBand = 1024;

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
    row_begin_.assign(num_nodes, 0);
    row_length_.assign(num_nodes, 0);
    diagonal_.assign(num_nodes, 0.0);
    null_vector_.assign(num_nodes, 0.0);
    const auto value = [&](std::size_t k) {
        return kind == LaplacianKind::unweighted ? 1.0 : graph.weights[k];
    };

    // The sums of the rows of W's off-diagonal part, and what scales row i: 1 / null_vector[i].
    for (std::size_t i = 0; i < num_nodes; ++i) {
        double loop = 0.0;
        for (std::size_t k = graph.row_begin[i]; k < graph.row_begin[i + 1]; ++k) {
            if (graph.columns[k] == i) loop += graph.weights[k];
            if (graph.columns[k] == i || graph.weights[k] == 0.0) continue;
            ++row_length_[i];
            diagonal_[i] += value(k);
        }
        if (kind == LaplacianKind::degree) null_vector_[i] = std::sqrt(diagonal_[i] + loop);
        if (kind == LaplacianKind::unweighted) null_vector_[i] = std::sqrt(diagonal_[i]);
        if (kind == LaplacianKind::area) null_vector_[i] = std::sqrt(graph.area_m2[i]);
        // A node alone: its row of L is 0, so any vector is in the null space.
        if (null_vector_[i] == 0.0) null_vector_[i] = 1.0;
    }

    row_order_.resize(num_nodes);
    std::iota(row_order_.begin(), row_order_.end(), 0U);
    for (auto first = row_order_.begin(); first != row_order_.end();) {
        const auto last = first + std::min<std::ptrdiff_t>(kRowsPerBand, row_order_.end() - first);
        std::stable_sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
            return row_length_[a] < row_length_[b];
        });
        first = last;
    }

    // Eq. (4): L = I - D^-1/2 W D^-1/2, in the form N^-1 (D' - W') N^-1 with loops cancelled, where
    // N is the diagonal of the null vector; so L_ii = 1 - w_ii / d_i.
    columns_.reserve(graph.columns.size());
    values_.reserve(graph.columns.size());
    double largest_row = 0.0;
    for (const std::uint32_t i : row_order_) {
        row_begin_[i] = columns_.size();
        diagonal_[i] /= null_vector_[i] * null_vector_[i];
        double row_sum = diagonal_[i];
        for (std::size_t k = graph.row_begin[i]; k < graph.row_begin[i + 1]; ++k) {
            if (graph.columns[k] == i || graph.weights[k] == 0.0) continue;
            columns_.push_back(graph.columns[k]);
            values_.push_back(-value(k) / (null_vector_[i] * null_vector_[graph.columns[k]]));
            row_sum -= values_.back();
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
        // Entries are stored in the order in which rows are visited.
        std::size_t k = row_begin_[row_order_[first]];
        for (std::size_t place = first; place < last; ++place) {
            const std::uint32_t i = row_order_[place];
            double sum = diagonal_[i] * x[i];
            for (const std::size_t end = k + row_length_[i]; k < end; ++k) {
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
        accelerator->multiply({diagonal_, row_begin_, row_length_, columns_, values_}, block,
                              result)) {
        return;
    }
    parallel_for(executor, block.size() / size(), 1, [&](std::size_t j, std::size_t) {
        apply(block.subspan(j * size(), size()), result.subspan(j * size(), size()));
    });
}

}  // namespace quadcut
