// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut {

/// What a cut of a graph costs: the sum over the parts S of cut(S) / volume(S), where cut(S) is the
/// weight of the edges that leave S. By degree, volume(S) is the weight of all edges of S's nodes:
/// Shi and Malik's normalised cut (and so for the unweighted kind); by area, the area of S.
/// `part_of_node`: one a node, numbered from 0. O(nodes + edges). Throws std::logic_error if there
/// are not as many as nodes, and where Laplacian() does.
[[nodiscard]] double normalised_cut(const Graph& graph, LaplacianKind kind,
                                    std::span<const std::uint32_t> part_of_node);

/// The graph in `num_parts` parts (as many as nodes if there are fewer), numbered from 0 and none
/// empty, with a small normalised cut. Multilevel: nodes are put together level by level along
/// heavy edges; the coarsest graph, some 32 nodes a part, is cut in two by the second eigenvector
/// again and again, where that costs least; back on each level, nodes move between parts while
/// that lowers the cost. So no eigenproblem grows with the graph. Parts need not be connected.
/// Throws NumericalError if the eigensolver fails its own checks, std::logic_error where
/// Laplacian() does. O(nodes + edges) beside the coarsest graph, whose size depends on num_parts
/// and on the number of components.
[[nodiscard]] std::vector<std::uint32_t> cut_multilevel(const Graph& graph, LaplacianKind kind,
                                                        std::size_t num_parts);

}  // namespace quadcut
