// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/eigengap.hpp"

#include <algorithm>
#include <limits>

namespace quadcut {
namespace {

/// Eigenvalues below this share of the largest are zero but for rounding.
constexpr double kZero = 1e-10;

}  // namespace

std::vector<double> relative_gaps(std::span<const double> values) {
    std::vector<double> gaps;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const double zero = kZero * values.back();
        if (values[i + 1] <= zero) {
            gaps.push_back(1.0);
        } else if (values[i] <= zero) {
            gaps.push_back(std::numeric_limits<double>::infinity());
        } else {
            gaps.push_back(values[i + 1] / values[i]);
        }
    }
    return gaps;
}

std::size_t num_clusters_by_eigengap(std::span<const double> values, std::size_t min_clusters,
                                     std::size_t max_clusters) {
    const std::vector<double> gaps = relative_gaps(values);
    const std::size_t last = std::min(max_clusters, gaps.size());
    if (last < min_clusters || min_clusters == 0) return 1;
    const auto first = gaps.begin() + static_cast<std::ptrdiff_t>(min_clusters - 1);
    const auto largest = std::max_element(first, gaps.begin() + static_cast<std::ptrdiff_t>(last));
    return 1 + static_cast<std::size_t>(largest - gaps.begin());
}

}  // namespace quadcut
