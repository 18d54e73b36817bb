// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/embedding.hpp"

namespace quadcut {

/// Clusters by column-pivoted QR (Damle, Minden, Ying 2019): the pivots of the transposed embedding
/// are one typical sample per cluster; the orthogonal polar factor of these rotates the embedding
/// so that each axis is a cluster; each sample goes to its largest coordinate in magnitude.
/// At most num_dims clusters, fewer if the rows span less or an axis gets no sample; labels are
/// numbered by first sample. Needs no start and no seed; the same for any number of threads.
/// The columns should be orthonormal and the rows unscaled, as embed() returns them by default.
/// O(samples * dims^2).
[[nodiscard]] Clustering cluster_pivoted_qr(const Embedding& samples,
                                            const Executor& executor = {});

}  // namespace quadcut
