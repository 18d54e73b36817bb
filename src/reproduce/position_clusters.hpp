// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/map/leaf_table.hpp"

namespace quadcut::reproduce {

/// The clusters, from 0 on, that k-means makes of the leaves' centres alone: no graph, so walls
/// play no part. What the paper holds its spectral clustering against. Fewer than asked for only if
/// there are fewer nodes.
[[nodiscard]] std::vector<std::uint32_t> cluster_positions(const LeafTable& table,
                                                           std::span<const LeafId> nodes,
                                                           std::size_t num_clusters,
                                                           std::uint64_t seed);

}  // namespace quadcut::reproduce
