// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/roofline.hpp"

#include <algorithm>
#include <limits>

namespace quadcut {
namespace {

// Measured on one thread of an AMD EPYC, docs/decisions/0016.
constexpr double kCpuSightEdgesPerS = 1.5e7;
constexpr double kCpuEntriesPerS = 1e9;
// The four kernels on PoCL took 0.85 us of a core of 2.6 GHz for a free leaf: at two operations a
// cycle. And what they touch: eight levels, two kernels, two sectors of 32 bytes.
constexpr double kOperationsPerNode = 4500.0;
constexpr double kMemoryBytesPerNode = 1000.0;

// Not measured: lanes compute 64-bit integers in about four steps, and about one in four has work
// while they wait for the longest line of sight among them; a driver's context and compiler.
constexpr double kLaneEfficiency = 1.0 / 16.0;
constexpr double kStartS = 0.2;

}  // namespace

double stage_s(const StageWork& work, const MachineRates& machine) {
    const double inside_s = std::max(work.operations / machine.operations_per_s,
                                     work.memory_bytes / machine.memory_bytes_per_s);
    return machine.start_s + work.num_launches * machine.launch_s +
           work.bytes_up / machine.link_bytes_per_s +
           std::max(inside_s, work.bytes_down / machine.link_bytes_per_s);
}

StageWork edge_stage(const EdgeStageSize& size) {
    const auto nodes = static_cast<double>(size.num_nodes);
    StageWork work;
    work.operations = kOperationsPerNode * nodes;
    // What sight_stage.cpp sends and fetches.
    work.bytes_up = 16.0 * static_cast<double>(size.num_leaves) + 8.0 * nodes +
                    4.0 * static_cast<double>(size.num_tiles) +
                    72.0 * static_cast<double>(size.num_mixed_tiles);
    work.bytes_down = 4.0 * nodes + 16.0 * static_cast<double>(size.num_edges);
    work.memory_bytes = kMemoryBytesPerNode * nodes + work.bytes_up + work.bytes_down;
    work.num_launches = 4.0 + work.bytes_down / 1e6;
    return work;
}

StageWork block_product(std::size_t num_rows, std::size_t num_entries, std::size_t num_vectors) {
    const auto rows = static_cast<double>(num_rows);
    const auto entries = static_cast<double>(num_entries);
    const auto vectors = static_cast<double>(num_vectors);
    StageWork work;
    work.operations = 2.0 * (entries + rows) * vectors;
    work.bytes_up = 20.0 * rows + 12.0 * entries + 8.0 * rows * vectors;
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

MachineRates discrete_gpu() {
    // 896 lanes at 1.66 GHz, 128 GB/s, PCI Express 3.0 x16 at 10 of its 15.8 GB/s.
    return {896 * 1.66e9 * kLaneEfficiency, 128e9, 10e9, 1e-5, kStartS};
}

MachineRates integrated_gpu() {
    // 256 lanes at 1.55 GHz, two channels of DDR4-3200.
    return {256 * 1.55e9 * kLaneEfficiency, 51.2e9, std::numeric_limits<double>::infinity(), 1e-5,
            kStartS};
}

}  // namespace quadcut
