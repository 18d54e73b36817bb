// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadcut/base/ids.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

// Of the map and of the paper's graph, which this folder does not know.
class LeafTable;
enum class SelfLoops : std::uint8_t;

/// A symmetric matrix as Laplacian keeps it: its diagonal, and what lies beside it, row by row in
/// any order: row i is entries row_begin[i] .. row_begin[i] + row_length[i] - 1.
struct MatrixRows {
    std::span<const double> diagonal;
    std::span<const std::size_t> row_begin;
    std::span<const std::uint32_t> row_length;
    std::span<const std::uint32_t> columns;
    std::span<const double> values;
};

/// A device beside the CPU (an Executor carries it), for the work that is many small equal parts.
/// What it returns is what the CPU would have, bit for bit. It may decline any call, because it has
/// failed or because the call would not pay; then the CPU does it. Never throws; any thread may
/// call it.
class Accelerator {
public:
    virtual ~Accelerator() = default;

    /// sight_edges() of the same arguments, which are as it asks for; nothing = declined.
    [[nodiscard]] virtual std::optional<std::vector<WeightedEdge>> sight_edges(
        const LeafTable& table, std::span<const LeafId> nodes, double resolution_m,
        SelfLoops self_loops) = 0;

    /// result = matrix * block, for the vectors of a block, one after the other: each entry is the
    /// diagonal's part, plus those of the row, one by one. False = declined; `result` is then as
    /// it may be.
    [[nodiscard]] virtual bool multiply(const MatrixRows& matrix, std::span<const double> block,
                                        std::span<double> result) = 0;
};

}  // namespace quadcut
