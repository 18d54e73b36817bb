// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/options.hpp"

namespace quadcut {

/// Samples to cluster: one row a node, one column an eigenvector. Row-major.
struct Embedding {
    std::size_t num_samples = 0;
    std::size_t num_dims = 0;
    std::vector<double> values;

    [[nodiscard]] std::span<const double> row(std::size_t i) const {
        return std::span(values).subspan(i * num_dims, num_dims);
    }
};

/// Eqs. (5) and (6): the `num_dims` first eigenvectors as columns, each row a sample; all of them
/// if there are fewer. O(samples * dims).
[[nodiscard]] Embedding embed(const Eigenpairs& pairs, std::size_t num_dims,
                              RowScaling scaling = RowScaling::none);

/// Samples put into clusters 0 .. num_clusters - 1, none of them empty (unless there is no sample).
struct Clustering {
    std::vector<std::uint32_t> labels;
    std::size_t num_clusters = 0;
};

/// Clusters numbered by first sample; of `num_labels` labels, those of no sample disappear.
[[nodiscard]] Clustering numbered_by_first_sample(std::span<const std::uint32_t> labels,
                                                  std::size_t num_labels);

}  // namespace quadcut
