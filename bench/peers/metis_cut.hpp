// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/stop_watch.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut::peers {

/// METIS_PartGraphKway for the cut, its other options as they come: what its parts are to have
/// equal shares of (nodes, or weights of edges), and by how much more than its share a part may
/// have, in thousandths (30: as it comes).
struct MetisOptions {
    int num_parts = 256;
    bool balances_weight = false;
    int imbalance = 30;
};

struct MetisCut {
    std::vector<std::uint32_t> part_of_node;
    Duration time;
};

/// Only METIS's own call is timed. Its weights are whole numbers: hundredths of ours, 1 at least.
[[nodiscard]] MetisCut cut_with_metis(const Graph& graph, const MetisOptions& options);

}  // namespace quadcut::peers
