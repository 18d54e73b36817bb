// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>

namespace quadcut {

/// What a stage asks of a machine.
struct StageWork {
    /// Integer or floating operations, one lane each.
    double operations = 0.0;
    /// Bytes that its processors read and write.
    double memory_bytes = 0.0;
    /// Bytes to the device before anything can be done, and back from it.
    double bytes_up = 0.0;
    double bytes_down = 0.0;
    double num_launches = 0.0;
};

/// What a machine gives. The efficiency of its lanes is in `operations_per_s`.
struct MachineRates {
    double operations_per_s = 0.0;
    double memory_bytes_per_s = 0.0;
    /// Of the link; infinite where the memory is that of the CPU.
    double link_bytes_per_s = 0.0;
    double launch_s = 0.0;
    /// Once: the context, the kernels, the check against the CPU.
    double start_s = 0.0;
};

/// The roofline (Williams, Waterman, Patterson 2009) with a link: what goes up first, then the
/// slowest of operations, memory and what comes down, which overlap. Seconds.
[[nodiscard]] double stage_s(const StageWork& work, const MachineRates& machine);

/// A map, as the edge stage sees it.
struct EdgeStageSize {
    /// Free leaves, and all of them.
    std::size_t num_nodes = 0;
    std::size_t num_leaves = 0;
    std::size_t num_edges = 0;
    /// Of the leaf table's directory, and those of them that several leaves share.
    std::size_t num_tiles = 0;
    std::size_t num_mixed_tiles = 0;
};

[[nodiscard]] StageWork edge_stage(const EdgeStageSize& size);
/// The product of a matrix with a block of vectors; the matrix goes up, too.
[[nodiscard]] StageWork block_product(std::size_t num_rows, std::size_t num_entries,
                                      std::size_t num_vectors);

/// The same on the CPU, as measured (docs/decisions/0016), for so many threads. Seconds.
[[nodiscard]] double edge_stage_on_cpu_s(std::size_t num_edges, int num_threads);
[[nodiscard]] double block_product_on_cpu_s(std::size_t num_entries, std::size_t num_vectors,
                                            int num_threads);

/// What a GPU is taken for, which does not tell its rates: the lower end of what is sold, from data
/// sheets (docs/decisions/0016). One with memory of its own, one that shares the CPU's.
[[nodiscard]] MachineRates discrete_gpu();
[[nodiscard]] MachineRates integrated_gpu();

}  // namespace quadcut
