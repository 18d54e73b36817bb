// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/spectral/embedding.hpp"

namespace quadcut::test {

/// Samples in `num_blobs` round heaps; sample i belongs to heap i % num_blobs. The centres are the
/// first corners of a cube of side 1.
inline Embedding blobs(std::size_t num_samples, std::size_t num_blobs, std::size_t num_dims,
                       double spread, Random& random) {
    Embedding samples{num_samples, num_dims, {}};
    for (std::size_t i = 0; i < num_samples; ++i) {
        for (std::size_t d = 0; d < num_dims; ++d) {
            const double centre = ((i % num_blobs) >> d) % 2 == 1 ? 1.0 : 0.0;
            samples.values.push_back(centre + spread * random.normal());
        }
    }
    return samples;
}

/// Heap i % num_blobs, which is also the numbering by first sample.
inline std::vector<std::uint32_t> blob_labels(std::size_t num_samples, std::size_t num_blobs) {
    std::vector<std::uint32_t> labels;
    for (std::size_t i = 0; i < num_samples; ++i) {
        labels.push_back(static_cast<std::uint32_t>(i % num_blobs));
    }
    return labels;
}

inline double squared_distance(const Embedding& samples, std::size_t i, std::size_t j) {
    double sum = 0.0;
    for (std::size_t d = 0; d < samples.num_dims; ++d) {
        sum += std::pow(samples.row(i)[d] - samples.row(j)[d], 2);
    }
    return sum;
}

}  // namespace quadcut::test
