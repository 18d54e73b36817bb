// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace quadcut {

/// How far apart eigenvalues are, in their own measure: gaps[i] = values[i + 1] / values[i], and
/// infinite behind what counts as zero (1e-10 of the largest). Of ascending values; one fewer.
[[nodiscard]] std::vector<double> relative_gaps(std::span<const double> values);

/// The number of clusters k in min_clusters .. max_clusters behind whose eigenvalue the largest
/// relative gap lies (von Luxburg 2007, section 8.3, with relative gaps: eigenvalues of rooms span
/// decades); the least such k. Each connected component of a graph is a cluster at least. No more
/// than values.size() - 1, and 1 where that is below min_clusters.
[[nodiscard]] std::size_t num_clusters_by_eigengap(std::span<const double> values,
                                                   std::size_t min_clusters,
                                                   std::size_t max_clusters);

}  // namespace quadcut
