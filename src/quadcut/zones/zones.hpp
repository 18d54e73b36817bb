// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/map/zone.hpp"
#include "quadcut/segment/result.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/zones/options.hpp"

namespace quadcut {

/// The clustering of the paper's G_submap: the normalised cut of a graph of rooms. Its smallest
/// eigenvectors are solved, their rows, divided by sqrt(d), clustered along the edges, so that each
/// zone is connected. As many zones as options.count says; as the largest gap between eigenvalues
/// tells when that is 0, and none for kNoZones; never fewer than the graph has components, nor more
/// than nodes. The same zones in whatever order the rooms are, as far as areas and weights tell
/// them apart. Throws NumericalError if the eigensolver fails its checks. O(edges log edges) beside
/// the eigenpairs.
[[nodiscard]] Zones find_zones(const Graph& rooms, const ZoneOptions& options);

/// The zones of a result, from its doors (conductance.hpp); rooms that no door joins to others are
/// of the zone of the nearest.
[[nodiscard]] Zones find_zones(const Segmentation& segmentation, const ZoneOptions& options);

}  // namespace quadcut
