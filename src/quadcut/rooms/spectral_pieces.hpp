// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

/// Cuts a graph, whose weights have no unit, finer than rooms: the eigenvectors of its
/// area-normalised Laplacian below 0.8 / m^2, eight at most, are clustered, and what had that many
/// is cut again; so no solve has more pairs than that, however large the graph. An even floor has
/// pieces of 12 m^2, what is nearly closed to its surroundings is a piece whatever its size.
/// Connected parts, and parts of the recursion, below `min_area_m2` are not cut. Where the
/// eigensolver fails its own checks each node is a piece.
[[nodiscard]] Pieces cut_spectrally(const Graph& graph, double min_area_m2,
                                    const Executor& executor = {});

}  // namespace quadcut
