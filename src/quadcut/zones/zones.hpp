// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/map/zone.hpp"
#include "quadcut/segment/result.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/zones/covisibility.hpp"
#include "quadcut/zones/options.hpp"

namespace quadcut {

/// The clustering of the paper's G_submap: the normalised cut of a graph of rooms. Its smallest
/// eigenvectors are solved, the rows divided by sqrt(d) clustered along the edges. As many zones as
/// options.count says, by the largest relative eigengap when that is 0, none for kNoZones; never
/// fewer than the graph has components, nor more than it has nodes. The same zones in whatever
/// order the rooms are, but for rooms of equal area and weight. Throws NumericalError if the
/// eigensolver fails its checks. O(rooms log rooms) beside the eigenpairs.
[[nodiscard]] Zones find_zones(const Graph& rooms, const ZoneOptions& options);

/// Those of the graph that options.weights says; of conductances where scans saw nothing.
[[nodiscard]] Zones find_zones(const Segmentation& segmentation, const Covisibility& seen,
                               const ZoneOptions& options);
/// Those of the graph of conductances.
[[nodiscard]] Zones find_zones(const Segmentation& segmentation, const ZoneOptions& options);

}  // namespace quadcut
