// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "backends/roofline.hpp"

#include <algorithm>
#include <limits>

namespace quadcut {
namespace {

// Measured on one thread of an AMD EPYC, docs/decisions/0016.
constexpr double kCpuSightEdgesPerS = 1e7;
constexpr double kCpuEntriesPerS = 5e8;

}  // namespace

double stage_s(const StageWork& work, const MachineRates& machine) {
    const double inside_s = std::max(work.operations / machine.operations_per_s,
                                     work.memory_bytes / machine.memory_bytes_per_s);
    return machine.start_s + work.num_launches * machine.launch_s +
           work.bytes_up / machine.link_bytes_per_s +
           std::max(inside_s, work.bytes_down / machine.link_bytes_per_s);
}

StageWork edge_stage(std::size_t num_nodes, std::size_t num_leaves, std::size_t num_edges,
                     std::size_t num_tiles) {
    const auto nodes = static_cast<double>(num_nodes);
    const auto leaves = static_cast<double>(num_leaves);
    const auto edges = static_cast<double>(num_edges);
    const auto tiles = static_cast<double>(num_tiles);
    StageWork work;
    work.operations = 3000.0 * nodes;
    work.bytes_up = 16.0 * leaves + 8.0 * nodes + 4.0 * tiles + 72.0 * tiles / 2;
    work.bytes_down = 4.0 * nodes + 16.0 * edges;
    work.memory_bytes = 2.0 * work.bytes_up + work.bytes_down;
    work.num_launches = 4.0;
    return work;
}

StageWork block_product(std::size_t num_rows, std::size_t num_entries, std::size_t num_vectors) {
    const auto rows = static_cast<double>(num_rows);
    const auto entries = static_cast<double>(num_entries);
    const auto vectors = static_cast<double>(num_vectors);
    StageWork work;
    work.operations = 2.0 * (entries + rows) * vectors;
    work.bytes_up = 16.0 * rows + 12.0 * entries + 8.0 * rows * vectors;
    work.bytes_down = 8.0 * rows * vectors;
    // Each vector reads the matrix, and its own entries at least once.
    work.memory_bytes = (16.0 * rows + 12.0 * entries + 16.0 * rows) * vectors;
    work.num_launches = vectors / 4.0;
    return work;
}

double edge_stage_on_cpu_s(std::size_t num_edges, int num_threads) {
    return static_cast<double>(num_edges) / (kCpuSightEdgesPerS * num_threads);
}

double block_product_on_cpu_s(std::size_t num_entries, std::size_t num_vectors, int num_threads) {
    return static_cast<double>(num_entries) * static_cast<double>(num_vectors) /
           (kCpuEntriesPerS * num_threads);
}

MachineRates discrete_gpu() { return {2e11, 2e11, 1e10, 1e-5, 0.2}; }

MachineRates integrated_gpu() {
    return {5e10, 4e10, std::numeric_limits<double>::infinity(), 1e-5, 0.2};
}

}  // namespace quadcut
