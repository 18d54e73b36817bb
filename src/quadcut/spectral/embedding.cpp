// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/embedding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadcut {
namespace {

double length_of(std::span<const double> row) {
    double squared = 0.0;
    for (const double value : row) squared += value * value;
    return std::sqrt(squared);
}

}  // namespace

Embedding embed(const Eigenpairs& pairs, std::size_t num_dims, RowScaling scaling) {
    // Eq. (5): P = [p_1, ..., p_k], the eigenvectors as columns.
    Embedding out;
    out.num_samples = pairs.num_nodes;
    out.num_dims = std::min(num_dims, pairs.size());
    out.values.resize(out.num_samples * out.num_dims);
    for (std::size_t j = 0; j < out.num_dims; ++j) {
        const auto vector = pairs.vector(j);
        // Eq. (6): sample i is the row (p_1i, ..., p_ki).
        for (std::size_t i = 0; i < out.num_samples; ++i) {
            out.values[i * out.num_dims + j] = vector[i];
        }
    }
    if (scaling == RowScaling::none) return out;
    for (std::size_t i = 0; i < out.num_samples; ++i) {
        const auto row = std::span(out.values).subspan(i * out.num_dims, out.num_dims);
        const double scale = scaling == RowScaling::degree ? pairs.null_vector[i] : length_of(row);
        if (scale == 0.0) continue;
        for (double& value : row) value /= scale;
    }
    return out;
}

Clustering numbered_by_first_sample(std::span<const std::uint32_t> labels, std::size_t num_labels) {
    constexpr auto kUnseen = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(num_labels, kUnseen);
    Clustering clustering;
    clustering.labels.reserve(labels.size());
    for (const std::uint32_t label : labels) {
        if (number[label] == kUnseen) {
            number[label] = static_cast<std::uint32_t>(clustering.num_clusters++);
        }
        clustering.labels.push_back(number[label]);
    }
    return clustering;
}

}  // namespace quadcut
