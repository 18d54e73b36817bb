// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <filesystem>

#include "quadcut/spectral/graph.hpp"

namespace quadcut::peers {

/// The border graph of a simulated, furnished building: the free leaves of its map, and the lengths
/// of their common borders as the product weighs them; the largest component.
[[nodiscard]] Graph plan_graph(int num_rooms, double resolution_m);

/// Writes a graph for peers.py: numbers of nodes and of entries, row_begin (64 bits each), columns
/// (32 bits), weights (doubles), in the machine's byte order.
void write_graph(const Graph& graph, const std::filesystem::path& path);

}  // namespace quadcut::peers
